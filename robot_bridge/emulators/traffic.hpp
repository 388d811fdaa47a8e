#pragma once

#include "robot_bridge/emulators/time.hpp"

#include <cstdint>
#include <deque>

namespace lamprey::robot_bridge::emulators {

/// Counts one direction's octets.
class Traffic {
 public:
  /// An octet passed at `time`; times do not decrease.
  void passed(Time time);

  std::uint64_t octets() const { return octets_; }
  /// The most that ever passed within one second.
  std::uint64_t peak_per_second() const { return peak_; }

 private:
  std::uint64_t octets_ = 0;
  std::uint64_t peak_ = 0;
  std::deque<Time> last_second_;
};

}  // namespace lamprey::robot_bridge::emulators
