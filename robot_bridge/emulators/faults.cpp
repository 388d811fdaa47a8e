#include "robot_bridge/emulators/faults.hpp"

#include <cmath>
#include <utility>

namespace lamprey::robot_bridge::emulators {

std::optional<Answer> Faults::apply(Answer answer) {
  if (silence) return std::nullopt;
  if (partial) answer.octets.resize(answer.octets.size() / 2);
  if (noise > 0) {
    std::vector<std::uint8_t> disturbed;
    for (const std::uint8_t octet : answer.octets) {
      const bool hit = uniform() < noise;
      const bool replaced = hit && (random_() & 1U) != 0;
      if (hit) disturbed.push_back(static_cast<std::uint8_t>(random_()));
      if (!replaced) disturbed.push_back(octet);
    }
    answer.octets = std::move(disturbed);
  }
  answer.asked += slow;
  if (answer.octets.empty()) return std::nullopt;
  return answer;
}

void Faults::clear() {
  silence = false;
  partial = false;
  noise = 0;
  slow = Time::zero();
}

double Faults::uniform() {
  return std::ldexp(static_cast<double>(random_() >> 11U), -53);
}

}  // namespace lamprey::robot_bridge::emulators
