#include "robot_bridge/emulators/traffic.hpp"

#include <algorithm>

namespace lamprey::robot_bridge::emulators {

void Traffic::passed(Time time) {
  ++octets_;
  last_second_.push_back(time);
  while (last_second_.front() <= time - std::chrono::seconds{1}) last_second_.pop_front();
  peak_ = std::max<std::uint64_t>(peak_, last_second_.size());
}

}  // namespace lamprey::robot_bridge::emulators
