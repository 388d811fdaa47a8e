#pragma once

#include "robot_bridge/driver.hpp"

#include <memory>

namespace lamprey::robot_bridge {

/// Connects to the device and reads from it, but sends it nothing that moves a servo or turns one on or off: its
/// feedback is what was commanded, with the contacts of standing feet.
std::unique_ptr<Driver> make_dry_run_driver(std::unique_ptr<Driver> device);

}  // namespace lamprey::robot_bridge
