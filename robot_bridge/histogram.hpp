#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace lamprey::robot_bridge {

/// Durations from 1 µs to over an hour in buckets of at most 1/16 of their size, so that a quantile is right to about
/// 6 %. A value; not thread-safe.
class Histogram {
 public:
  /// A negative one counts as 0.
  void add(std::chrono::nanoseconds duration);

  std::uint64_t count() const { return count_; }
  std::chrono::microseconds largest() const { return largest_; }

  /// Below or at which that share (0..1) of the durations is; 0 where there are none.
  std::chrono::microseconds quantile(double share) const;

 private:
  static constexpr std::size_t steps = 16;  ///< buckets per doubling
  static constexpr std::size_t doublings = 28;

  std::array<std::uint64_t, steps * doublings> buckets_{};
  std::uint64_t count_ = 0;
  std::chrono::microseconds largest_{0};
};

}  // namespace lamprey::robot_bridge
