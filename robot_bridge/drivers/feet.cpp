#include "robot_bridge/drivers/feet.hpp"

#include <cmath>

namespace lamprey::robot_bridge::drivers {

using science::robots::legs;

std::uint32_t feet_down(const Calibration& calibration, const Pose& position,
                        const std::function<bool(std::int32_t)>& is_high) {
  std::uint32_t down = 0;
  for (std::size_t leg = 0; leg < legs; ++leg) {
    const auto& foot = calibration.feet[leg];
    const double height = position[science::robots::vertical_servo(leg)];
    const bool is_down =
        foot ? is_high(foot->channel) != foot->closed_is_low : std::round(height) <= science::robots::flat_ground_level;
    down |= std::uint32_t{is_down} << leg;
  }
  return down;
}

std::vector<std::int32_t> contact_channels(const Calibration& calibration) {
  std::vector<std::int32_t> channels;
  for (const auto& foot : calibration.feet) {
    if (foot) channels.push_back(foot->channel);
  }
  return channels;
}

}  // namespace lamprey::robot_bridge::drivers
