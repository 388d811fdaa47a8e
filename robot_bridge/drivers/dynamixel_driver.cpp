#include "robot_bridge/drivers/dynamixel_driver.hpp"

#include "robot_bridge/drivers/feet.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace lamprey::robot_bridge::drivers {

namespace {

using dynamixel::Octets;
using dynamixel::Register;
using dynamixel::StatusPacket;
using Kind = DriverError::Kind;

constexpr std::uint32_t time_based_profile = 1U << 2U;  // of the drive mode
constexpr std::uint32_t profile_ongoing = 1U << 1U;     // of the moving status
constexpr std::uint32_t position_control = 3;           // of the operating mode
constexpr std::int64_t longest_profile = 32737;         // milliseconds
constexpr double control_loop_rate = 1000;              // of a servo, per second
constexpr double exchange_time = 0.001;                 // seconds: a USB frame, for the adapter to answer
constexpr double default_return_delay = 0.0005;         // seconds, of a contact board
constexpr double seconds_per_delay = 2e-6;

std::vector<std::uint8_t> ids_of(const Calibration& calibration) {
  std::vector<std::uint8_t> ids;
  for (const auto& joint : calibration.joints) ids.push_back(static_cast<std::uint8_t>(joint.channel));
  return ids;
}

Register contact_octet(const ContactBoard& board) {
  return {static_cast<std::uint16_t>(board.address), 1};
}

std::string board_text(const ContactBoard& board) {
  return "contact board (id " + std::to_string(board.id) + ")";
}

}  // namespace

DynamixelDriver::DynamixelDriver(const Calibration& calibration, std::string port)
    : SerialDriver(calibration, std::move(port)), ids_(ids_of(calibration)) {}

std::string DynamixelDriver::description() const {
  std::array<char, 32> rate{};
  std::snprintf(rate.data(), rate.size(), "%.4g", std::floor(highest_rate()));
  std::string text = "Dynamixel servos at " + line().port() + ", " + std::to_string(line().baud()) + " baud, at most " +
                     rate.data() + " steps per second";
  const auto slowest = std::ranges::max(return_delay_);
  if (slowest > 0) text += ", return delay time up to " + std::to_string(2 * slowest) + " µs (0 is best)";
  return text + alerts_;
}

double DynamixelDriver::highest_rate() const {
  double seconds = std::chrono::duration<double>(line().wire_time(octets_per_step())).count() + exchange_time;
  for (const auto delay : return_delay_) seconds += seconds_per_delay * delay;
  if (calibration().contact_board) seconds += exchange_time + default_return_delay;
  return std::min(control_loop_rate, 1 / seconds);
}

void DynamixelDriver::greet() {
  alerts_.clear();
  for (std::size_t servo = 0; servo < servos; ++servo) {
    exchange(dynamixel::ping(ids_[servo]), ids_[servo], 3, servo_text(calibration(), servo), Alerts::are_left);
  }
  if (const auto& board = calibration().contact_board) {
    const auto id = static_cast<std::uint8_t>(board->id);
    exchange(dynamixel::ping(id), id, 3, board_text(*board), Alerts::are_left);
  }
  const auto modes = read_all(dynamixel::operating_mode, Alerts::are_left);
  const auto torques = read_all(dynamixel::torque_enable, Alerts::are_left);
  return_delay_ = {};
  const auto delays = read_all(dynamixel::return_delay_time, Alerts::are_left);
  const auto errors = read_all(dynamixel::hardware_error_status, Alerts::are_left);
  for (std::size_t servo = 0; servo < servos; ++servo) {
    const std::string who = servo_text(calibration(), servo);
    if (modes[servo] != position_control) {
      throw DriverError(Kind::refused, who + " is in operating mode " + std::to_string(modes[servo]) +
                                           "; it must be in 3, position control");
    }
    if (torques[servo] != 0) {
      return_delay_[servo] = delays[servo];
    } else if (delays[servo] != 0) {
      write_one(servo, dynamixel::return_delay_time, 0, Alerts::are_left);
    }
    if (errors[servo] != 0) alerts_ += "; " + who + " reports " + dynamixel::hardware_error_text(errors[servo]);
  }
}

std::optional<Pose> DynamixelDriver::locate() {
  return pose_of(positions());
}

void DynamixelDriver::turn_on(const Pose& start) {
  const auto torques = read_all(dynamixel::torque_enable);
  const auto drive_modes = read_all(dynamixel::drive_mode);
  for (std::size_t servo = 0; servo < servos; ++servo) {
    if ((drive_modes[servo] & time_based_profile) != 0) continue;
    if (torques[servo] != 0) {
      throw DriverError(Kind::refused, servo_text(calibration(), servo) +
                                           " has torque, and no time-based profile (drive mode, bit 2), which can't be "
                                           "set before its torque is off");
    }
    write_one(servo, dynamixel::drive_mode, drive_modes[servo] | time_based_profile);
  }
  write_all(dynamixel::profile_acceleration, 0);
  const auto ticks = positions();
  for (std::size_t servo = 0; servo < servos; ++servo) {
    const auto position = sent_position(joint(servo), servo, start[servo]);
    if (position.device == ticks[servo]) sent[servo] = position;
    if (torques[servo] != 0) continue;
    write_one(servo, dynamixel::goal_position, static_cast<std::uint32_t>(ticks[servo]));
    write_one(servo, dynamixel::torque_enable, 1);
  }
}

void DynamixelDriver::begin_move(std::chrono::microseconds duration) {
  const auto rounded = std::chrono::round<std::chrono::milliseconds>(duration).count();
  std::array<std::int32_t, servos> ticks{};
  for (std::size_t servo = 0; servo < servos; ++servo) ticks[servo] = sent[servo]->device;
  write_goals(ticks, static_cast<std::uint32_t>(std::clamp<std::int64_t>(rounded, 1, longest_profile)));
}

Feedback DynamixelDriver::sense() {
  Feedback feedback;
  const auto ticks = positions();
  feedback.position = pose_of(ticks);
  for (std::size_t servo = 0; servo < servos; ++servo) {
    if (sent[servo] && sent[servo]->device != ticks[servo]) feedback.arrived = false;
  }
  feedback.measured = true;
  std::uint32_t contacts = 0;
  if (const auto& board = calibration().contact_board) {
    const auto id = static_cast<std::uint8_t>(board->id);
    contacts = exchange(dynamixel::read(id, contact_octet(*board)), id, 1, board_text(*board)).parameters[0];
  }
  feedback.feet_down =
      feet_down(calibration(), feedback.position, [&](std::int32_t bit) { return (contacts >> bit & 1U) != 0; });
  return feedback;
}

bool DynamixelDriver::ask_whether_moving() {
  const auto statuses = read_all(dynamixel::moving_status);
  return std::ranges::any_of(statuses, [](std::uint32_t status) { return (status & profile_ongoing) != 0; });
}

void DynamixelDriver::stop() {
  write_goals(positions(Alerts::are_left), 1);
}

void DynamixelDriver::send_release() {
  write_all(dynamixel::torque_enable, 0);
}

void DynamixelDriver::confirm_release() {
  const auto torques = read_all(dynamixel::torque_enable, Alerts::are_left);
  for (std::size_t servo = 0; servo < servos; ++servo) {
    if (torques[servo] != 0) throw DriverError(Kind::refused, servo_text(calibration(), servo) + " keeps its torque");
  }
}

std::vector<std::int32_t> DynamixelDriver::positions(Alerts alerts) {
  std::vector<std::int32_t> ticks;
  for (const auto value : read_all(dynamixel::present_position, alerts))
    ticks.push_back(static_cast<std::int32_t>(value));
  return ticks;
}

/// Exactly what was asked for, where a servo has reached its tick.
Pose DynamixelDriver::pose_of(const std::vector<std::int32_t>& ticks) const {
  Pose pose{};
  for (std::size_t servo = 0; servo < servos; ++servo) {
    const auto& goal = sent[servo];
    pose[servo] = goal && goal->device == ticks[servo] ? goal->units : joint(servo).to_units(ticks[servo]);
  }
  return pose;
}

/// The profile's time and the goal stand side by side in the control table.
void DynamixelDriver::write_goals(std::span<const std::int32_t> ticks, std::uint32_t milliseconds) {
  std::vector<dynamixel::SyncValue> values;
  for (std::size_t servo = 0; servo < servos; ++servo) {
    Octets octets;
    dynamixel::append(octets, milliseconds, dynamixel::profile_velocity.octets);
    dynamixel::append(octets, static_cast<std::uint32_t>(ticks[servo]), dynamixel::goal_position.octets);
    values.push_back({.id = ids_[servo], .octets = std::move(octets)});
  }
  send(dynamixel::sync_write(dynamixel::profile_velocity.address, values));
}

void DynamixelDriver::write_all(Register what, std::uint32_t value) {
  std::vector<dynamixel::SyncValue> values;
  for (const auto id : ids_) {
    values.push_back({.id = id, .octets = {}});
    dynamixel::append(values.back().octets, value, what.octets);
  }
  send(dynamixel::sync_write(what.address, values));
}

void DynamixelDriver::write_one(std::size_t servo, Register what, std::uint32_t value, Alerts alerts) {
  exchange(dynamixel::write(ids_[servo], what, value), ids_[servo], 0, servo_text(calibration(), servo), alerts);
}

std::vector<std::uint32_t> DynamixelDriver::read_all(Register what, Alerts alerts) {
  const Octets instruction = dynamixel::sync_read(what, ids_);
  send(instruction);
  const auto deadline = answer_deadline(instruction.size() + servos * (dynamixel::status_overhead + what.octets));
  std::vector<StatusPacket> answers;
  for (std::size_t servo = 0; servo < servos; ++servo) {
    answers.push_back(next_status(ids_[servo], what.octets, servo_text(calibration(), servo), deadline));
  }
  // Not before all have answered: asking for the reason needs a quiet line.
  std::vector<std::uint32_t> values;
  for (std::size_t servo = 0; servo < servos; ++servo) {
    throw_if_error(answers[servo], servo_text(calibration(), servo), alerts);
    values.push_back(dynamixel::value_of(answers[servo].parameters));
  }
  return values;
}

StatusPacket DynamixelDriver::exchange(const Octets& instruction, std::uint8_t id, std::size_t parameters,
                                       const std::string& who, Alerts alerts) {
  send(instruction);
  const auto deadline = answer_deadline(instruction.size() + dynamixel::status_overhead + parameters);
  auto status = next_status(id, parameters, who, deadline);
  throw_if_error(status, who, alerts);
  return status;
}

void DynamixelDriver::send(const Octets& instruction) {
  line().drain_input();
  decoder_.clear();
  line().write(instruction, answer_deadline(instruction.size()));
}

StatusPacket DynamixelDriver::next_status(std::uint8_t id, std::size_t parameters, const std::string& who,
                                          SerialLine::Deadline deadline) {
  bool something_came = false;
  while (true) {
    auto result = decoder_.next();
    if (result.kind == dynamixel::StatusDecoder::Kind::garbled) {
      throw DriverError(Kind::garbled, "noise instead of an answer of " + who);
    }
    if (result.kind == dynamixel::StatusDecoder::Kind::status) {
      const bool failed = (result.status.error & ~dynamixel::alert_bit) != 0;
      if (result.status.id == id && (failed || result.status.parameters.size() == parameters)) return result.status;
      throw DriverError(Kind::garbled, "not the answer that " + who + " was asked for, but one of id " +
                                           std::to_string(result.status.id) + " with " +
                                           std::to_string(result.status.parameters.size()) + " octets");
    }
    const auto octets = line().read_some(deadline);
    if (octets.empty() && (something_came || decoder_.pending() > 0))
      throw DriverError(Kind::garbled, "only a part of an answer of " + who);
    if (octets.empty()) throw DriverError(Kind::silent, "no answer of " + who);
    decoder_.add(octets);
    something_came = true;
  }
}

/// Asks a servo with an alert for the reason.
void DynamixelDriver::throw_if_error(const StatusPacket& status, const std::string& who, Alerts alerts) {
  if (const auto text = dynamixel::error_text(status.error); !text.empty()) {
    throw DriverError(Kind::refused, who + " answers with an error: " + text);
  }
  if ((status.error & dynamixel::alert_bit) == 0 || alerts == Alerts::are_left) return;
  const auto reason = exchange(dynamixel::read(status.id, dynamixel::hardware_error_status), status.id,
                               dynamixel::hardware_error_status.octets, who, Alerts::are_left);
  throw DriverError(Kind::refused,
                    who + " reports " + dynamixel::hardware_error_text(dynamixel::value_of(reason.parameters)));
}

/// A move, a sync read of all positions with its answers, and where there is one, the contact board.
std::size_t DynamixelDriver::octets_per_step() const {
  constexpr std::size_t frame = 14;  // of a sync instruction
  const std::size_t move = frame + servos * (1 + dynamixel::profile_velocity.octets + dynamixel::goal_position.octets);
  const std::size_t query = frame + servos;
  const std::size_t answers = servos * (dynamixel::status_overhead + dynamixel::present_position.octets);
  const std::size_t board = calibration().contact_board ? frame + dynamixel::status_overhead + 1 : 0;
  return move + query + answers + board;
}

}  // namespace lamprey::robot_bridge::drivers
