#pragma once

#include "robot_bridge/emulators/line.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace lamprey::robot_bridge::emulators {

/// What a control command may ask of the program around the line. They throw std::runtime_error if that can't be done.
struct ProgramActions {
  std::function<void()> unplug;
  std::function<void()> replug;
  std::function<std::string()> report;  ///< one line of JSON
};

/// Does what one line asks for at `now`, and returns the one line that answers it: "ok", JSON, or "error …", after
/// which nothing has changed.
std::string control(std::string_view line, Line& emulated, const ProgramActions& actions, Time now);

}  // namespace lamprey::robot_bridge::emulators
