#include "robot_bridge/emulators/line.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace lamprey::robot_bridge::emulators {

std::vector<std::uint8_t> Line::run(Time now) {
  for (const auto& [octet, time] : to_controller_.take(now)) {
    received_.passed(time);
    controller_->receive(octet, time);
    for (Answer& asked : controller_->take_answers()) {
      const auto answer = faults_.apply(std::move(asked));
      if (!answer) continue;
      from_controller_.send(answer->octets, std::max(answer->asked, from_controller_.free_at()) + answer->delay,
                            answer->gap);
    }
  }
  std::vector<std::uint8_t> octets;
  for (const auto& [octet, time] : from_controller_.take(now)) {
    answered_.passed(time);
    octets.push_back(octet);
  }
  return octets;
}

std::optional<Time> Line::next() const {
  const auto in = to_controller_.next();
  const auto out = from_controller_.next();
  if (!in || !out) return in ? in : out;
  return std::min(*in, *out);
}

void Line::cut() {
  to_controller_.clear();
  from_controller_.clear();
  controller_->disconnected();
}

nlohmann::json Line::report() const {
  return {{"octets_received", received_.octets()},
          {"octets_answered", answered_.octets()},
          {"peak_octets_received_per_second", received_.peak_per_second()},
          {"peak_octets_answered_per_second", answered_.peak_per_second()},
          {"octets_at_another_speed", at_another_speed_},
          {"octets_overrun", overrun_}};
}

}  // namespace lamprey::robot_bridge::emulators
