#pragma once

#include "robot_bridge/calibration.hpp"
#include "robot_bridge/driver.hpp"

#include <memory>
#include <string>

namespace lamprey::robot_bridge {

/// The driver of the calibration's device, which is not yet connected. `port` is the serial line's path; the mock needs
/// none. Throws std::invalid_argument where no driver is registered for the family. Names of drivers are checked where
/// a calibration is read.
std::unique_ptr<Driver> make_driver(const Calibration& calibration, const std::string& port);

}  // namespace lamprey::robot_bridge
