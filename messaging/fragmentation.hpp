#pragma once

#include "messaging/samples.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

/// Long outcomes and recordings in small samples: cut by the worker, put together by the coordinator.
namespace lamprey::messaging {

/// A result sample stays below about this many bytes.
inline constexpr std::size_t maximum_sample_bytes = 64 * 1024;

/// A longer reason of a failure is cut to this many bytes by fragments().
inline constexpr std::size_t maximum_reason_bytes = 4096;

/// Bytes of a result on the wire, closely enough to fill samples by.
std::size_t wire_bytes(const JobResult& result);

/// The result as one or more fragments, each below maximum_sample_bytes, in order.
std::vector<JobResult> fragments(const JobResult& whole);

/// Puts fragments together, whatever their order and however often each comes. Not thread-safe.
class Assembler {
 public:
  /// `most_bytes`: of incomplete results held at once; beyond it the oldest is dropped (its worker sends it again). A
  /// single one may be longer than that: it must still be able to end.
  explicit Assembler(std::size_t most_bytes = std::size_t{256} << 20) : most_bytes_(most_bytes) {}

  /// The whole result once its last missing fragment has come. Fragments that contradict each other (another digest,
  /// another count) start the result anew. Throws nothing on malformed input: an impossible fragment is ignored.
  std::optional<JobResult> add(std::uint64_t worker, const Id128& sweep, JobResult fragment);

  std::size_t held_bytes() const { return held_bytes_; }
  /// How many incomplete results are held.
  std::size_t incomplete() const { return partial_.size(); }

 private:
  struct Key {
    std::uint64_t worker;
    Id128 sweep;
    std::uint64_t job;
    auto operator<=>(const Key&) const = default;
  };
  struct Partial {
    std::map<std::uint32_t, JobResult> parts;  // by fragment number; never empty
    std::size_t bytes = 0;
    std::uint64_t age = 0;  // when begun
  };
  using Partials = std::map<Key, Partial>;

  JobResult take(Partials::iterator complete);
  void drop(Partials::iterator position);
  void drop_oldest();

  Partials partial_;
  std::size_t most_bytes_;
  std::size_t held_bytes_ = 0;
  std::uint64_t next_age_ = 0;
};

}  // namespace lamprey::messaging
