#pragma once

#include "robot_bridge/calibration.hpp"

#include <string>

namespace lamprey::robot_bridge::calibrate {

/// Writes the calibration, whole or not at all; a file that was there is kept as FILE.before. Throws
/// experiment::InvalidInput if a bridge would refuse it, and std::runtime_error if it can't be written; then nothing
/// has changed.
void write_calibration(const Calibration& calibration, const std::string& path);

}  // namespace lamprey::robot_bridge::calibrate
