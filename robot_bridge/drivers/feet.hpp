#pragma once

#include "robot_bridge/calibration.hpp"
#include "robot_bridge/pose.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace lamprey::robot_bridge::drivers {

/// The feet that are down, a bit per leg: by their contact, or where the calibration has none, by the leg's position,
/// which is rounded to whole units, since a sensor's last digit must lift no foot. `is_high` tells the level of a
/// contact by its channel.
std::uint32_t feet_down(const Calibration& calibration, const Pose& position,
                        const std::function<bool(std::int32_t)>& is_high);

/// The channels of the contacts that the calibration has.
std::vector<std::int32_t> contact_channels(const Calibration& calibration);

}  // namespace lamprey::robot_bridge::drivers
