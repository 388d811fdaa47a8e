#include "robot_bridge/calibration.hpp"

#include "robot_bridge/calibration_fields.hpp"
#include "science/problems/controlled_quadruped.hpp"

#include <algorithm>

namespace lamprey::robot_bridge {

namespace {

std::string joint_text(const Joint& joint) {
  std::string text = "{channel: " + std::to_string(joint.channel);
  const auto add = [&](std::string_view name, double value) {
    text.append(", ").append(name).append(": ").append(number_text(value));
  };
  add("minimum", joint.minimum);
  add("centre", joint.centre);
  add("maximum", joint.maximum);
  add("per_unit", joint.per_unit);
  text += ", direction: " + std::to_string(joint.direction);
  add("offset", joint.offset);
  add("slew_rate", joint.slew_rate);
  return text + "}";
}

std::string foot_text(DeviceFamily family, const FootContact& foot) {
  const std::string place = family == DeviceFamily::ssc32
                                ? "input: " + std::string(1, static_cast<char>('A' + foot.channel))
                                : "bit: " + std::to_string(foot.channel);
  return "{" + place + ", closed: " + (foot.closed_is_low ? "low" : "high") + "}";
}

}  // namespace

double Joint::to_device(double units) const {
  const double device = centre + offset + direction * per_unit * (units - science::robots::standing_position);
  // In this order what is no number ends within the range too.
  return std::min(maximum, std::max(minimum, device));
}

double Joint::to_units(double device) const {
  return science::robots::standing_position + (device - centre - offset) / (direction * per_unit);
}

double slew_in_units(const Joint& joint) {
  return joint.slew_rate / joint.per_unit;
}

std::string_view to_text(DeviceFamily family) {
  switch (family) {
    case DeviceFamily::mock:
      return "mock";
    case DeviceFamily::ssc32:
      return "ssc32";
    case DeviceFamily::dynamixel:
      return "dynamixel";
  }
  return {};
}

std::string to_yaml(const Calibration& calibration) {
  std::string text = "driver: " + std::string(to_text(calibration.family)) + "\n";
  text += "baud: " + std::to_string(calibration.baud) + "\njoints:\n";
  const auto names = science::problems::servo_names();
  for (std::size_t servo = 0; servo < servos; ++servo) {
    text += "  " + names[servo] + ": " + joint_text(calibration.joints[servo]) + "\n";
  }
  if (std::ranges::any_of(calibration.feet, [](const auto& foot) { return foot.has_value(); })) text += "feet:\n";
  for (std::size_t leg = 0; leg < leg_names.size(); ++leg) {
    const auto& foot = calibration.feet[leg];
    if (foot) text += "  " + std::string(leg_names[leg]) + ": " + foot_text(calibration.family, *foot) + "\n";
  }
  if (const auto& board = calibration.contact_board) {
    text += "contact_board: {id: " + std::to_string(board->id) + ", address: " + std::to_string(board->address) + "}\n";
  }
  return text;
}

Calibration mock_calibration() {
  Calibration calibration;
  for (std::size_t servo = 0; servo < servos; ++servo) {
    calibration.joints[servo] = {
        .channel = static_cast<std::int32_t>(servo),
        .minimum = lowest_position,
        .centre = science::robots::standing_position,
        .maximum = highest_position,
        .per_unit = 1,
        .direction = 1,
        .offset = 0,
        .slew_rate = 1000 * (highest_position - lowest_position),  // from end to end in one of 1000 steps per second
    };
  }
  return calibration;
}

}  // namespace lamprey::robot_bridge
