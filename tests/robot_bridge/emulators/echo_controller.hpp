#pragma once

#include "robot_bridge/emulators/controller.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace lamprey::robot_bridge::emulators {

/// Answers each octet with itself and its successor, after 100 µs, and remembers what it was told.
class EchoController : public Controller {
 public:
  void receive(std::uint8_t octet, Time time) override {
    received.emplace_back(octet, time);
    answers_.push_back({{octet, static_cast<std::uint8_t>(octet + 1)}, time, std::chrono::microseconds{100}});
  }
  std::vector<Answer> take_answers() override { return std::exchange(answers_, {}); }
  void disconnected() override { ++disconnections; }
  void overload(unsigned servo, bool on, Time) override {
    if (servo > 3) throw std::invalid_argument("no servo '" + std::to_string(servo) + "'");
    told.push_back("overload " + std::to_string(servo) + (on ? " on" : " off"));
  }
  void place(unsigned servo, double position, Time) override {
    told.push_back("place " + std::to_string(servo) + " " + std::to_string(position));
  }
  void reset(Time) override { told.emplace_back("reset"); }
  nlohmann::json state(Time time) override { return {{"time", time.count()}}; }

  std::vector<std::pair<std::uint8_t, Time>> received;
  std::vector<std::string> told;
  int disconnections = 0;

 private:
  std::vector<Answer> answers_;
};

}  // namespace lamprey::robot_bridge::emulators
