#include "robot_bridge/emulators/dynamixel/servo.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

namespace lamprey::robot_bridge::emulators::dynamixel {
namespace {

// Units of the control table.
constexpr double ticks_per_turn = 4096;
constexpr double velocity_unit = 0.229 * ticks_per_turn / 60;               // 0.229 rev/min, in ticks/s
constexpr double acceleration_unit = 214.577 * ticks_per_turn / (60 * 60);  // 214.577 rev/min², in ticks/s²
constexpr Time return_delay_unit = std::chrono::microseconds{2};
constexpr Time watchdog_unit = std::chrono::milliseconds{20};

constexpr std::int64_t watchdog_error = -1;
constexpr std::int64_t time_based_profile = 4;
constexpr std::uint8_t first_firmware_with_times = 42;
constexpr std::int64_t overload_error = 1 << 5;
constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::int64_t position_control = 3;
constexpr std::int64_t extended_position_control = 4;
constexpr std::int64_t current_based_position_control = 5;

Time from_seconds(double seconds) {
  return std::chrono::duration_cast<Time>(std::chrono::duration<double>(seconds));
}

}  // namespace

Servo::Servo(const ServoSettings& settings, Recorder& recorder)
    : settings_(settings), recorder_(&recorder), table_(xm430()), motion_(settings.position) {
  initialise(false);
}

void Servo::initialise(bool ram_only) {
  table_.initialise(ram_only);
  table_.set(id_number, settings_.id);
  table_.set(firmware_version, settings_.firmware);
  table_.set(baud_rate, settings_.baud_register);
  table_.set(goal_position, std::lround(motion_.position()));
  shut_down_ = false;
  registered_.reset();
}

std::uint16_t Servo::model() const {
  return static_cast<std::uint16_t>(table_.get(model_number));
}
Time Servo::return_delay() const {
  return table_.get(return_delay_time) * return_delay_unit;
}
std::uint8_t Servo::status_return_level() const {
  return static_cast<std::uint8_t>(table_.get(dynamixel::status_return_level));
}
bool Servo::torque() const {
  return table_.get(torque_enable) != 0;
}
bool Servo::moves_to_positions() const {
  const auto mode = table_.get(operating_mode);
  return mode == position_control || mode == extended_position_control || mode == current_based_position_control;
}

Error Servo::read(std::uint16_t address, std::uint16_t octets, std::vector<std::uint8_t>& values) {
  refresh();
  return table_.read(address, octets, values);
}

Error Servo::write(std::uint16_t address, std::span<const std::uint8_t> octets, Time time) {
  const bool had_torque = torque();
  std::vector<std::uint16_t> written;
  const Error error = table_.write(
      address, octets, [this](const Item& item, std::int64_t value) { return check(item, value); }, written);
  if (error == Error::none) changed(written, had_torque, time);
  return error;
}

Error Servo::reg_write(std::uint16_t address, std::span<const std::uint8_t> octets) {
  ControlTable trial = table_;
  std::vector<std::uint16_t> written;
  const Error error = trial.write(
      address, octets, [this](const Item& item, std::int64_t value) { return check(item, value); }, written);
  if (error != Error::none) return error;
  registered_ = Registered{address, {octets.begin(), octets.end()}};
  table_.set(registered_instruction, 1);
  return Error::none;
}

Error Servo::action(Time time) {
  if (!registered_) return Error::instruction;
  const Registered registered = *std::exchange(registered_, std::nullopt);
  table_.set(registered_instruction, 0);
  return write(registered.address, registered.octets, time);
}

void Servo::reboot(Time time) {
  set_torque(false, time);
  motion_.stop();
  initialise(true);
}

void Servo::power_cycle(Time time) {
  overloaded_ = false;
  reboot(time);
}

Error Servo::check(const Item& item, std::int64_t value) const {
  if (item.address < first_ram_address && torque()) return Error::access;
  switch (item.address) {
    case torque_enable:
      // "A reboot is the only method to reset Torque Enable to 1 after a shutdown."
      return value != 0 && shut_down_ ? Error::access : Error::none;
    case bus_watchdog:
      return value < 0 ? Error::data_range : Error::none;
    case goal_pwm:
    case goal_current:
    case goal_velocity:
      return table_.get(bus_watchdog) == watchdog_error ? Error::data_range : Error::none;
    case goal_position: {
      if (table_.get(bus_watchdog) == watchdog_error) return Error::data_range;
      const bool limited = table_.get(operating_mode) == position_control;
      const bool within = value >= table_.get(min_position_limit) && value <= table_.get(max_position_limit);
      return limited && !within ? Error::data_range : Error::none;
    }
    default:
      return check_mode(item, value);
  }
}

/// Settings that the emulation could not follow are refused.
Error Servo::check_mode(const Item& item, std::int64_t value) const {
  const auto only = [value](std::initializer_list<std::int64_t> possible) {
    return std::ranges::find(possible, value) == possible.end() ? Error::data_range : Error::none;
  };
  switch (item.address) {
    case id_number:
      return only({settings_.id});
    case baud_rate:
      return only({settings_.baud_register});
    case drive_mode:
      return settings_.firmware < first_firmware_with_times ? only({0}) : only({0, time_based_profile});
    case operating_mode:
      return only({0, 1, position_control, extended_position_control, current_based_position_control, 16});
    default:
      return Error::none;
  }
}

void Servo::changed(const std::vector<std::uint16_t>& addresses, bool had_torque, Time time) {
  const auto written = [&](std::uint16_t address) { return std::ranges::find(addresses, address) != addresses.end(); };
  if (written(goal_position)) {
    const auto goal = static_cast<int>(table_.get(goal_position));
    recorder_->target(settings_.id, goal, stated_duration(goal - motion_.position()), time);
    if (had_torque) go_to_goal();
  }
  if (written(operating_mode)) table_.set(goal_position, std::lround(motion_.position()));
  if (torque() != had_torque) {
    const bool on = torque();
    table_.set(torque_enable, had_torque ? 1 : 0);
    set_torque(on, time);
  }
}

void Servo::set_torque(bool on, Time time) {
  if (on == torque()) return;
  table_.set(torque_enable, on ? 1 : 0);
  if (!on) {
    motion_.stop();
    recorder_->turned_off(settings_.id, time);
    return;
  }
  // The goal is what it was set to last, torque or not: who has not set it to the present position makes it jump.
  recorder_->turned_on(settings_.id, motion_.position(), static_cast<int>(table_.get(goal_position)), time);
  go_to_goal();
  if (overloaded_) shut_down(time);
}

void Servo::go_to_goal() {
  if (!moves_to_positions()) return;
  const auto goal = static_cast<double>(table_.get(goal_position));
  motion_.go_to(goal, profile(std::abs(goal - motion_.position())));
}

void Servo::shut_down(Time time) {
  shut_down_ = true;
  table_.set(hardware_error_status, overload_error);
  set_torque(false, time);
}

void Servo::overload(bool on, Time time) {
  overloaded_ = on;
  if (on) shut_down(time);
}

/// Time-based: profile velocity is the whole time and profile acceleration the time of speeding up, both in ms, a
/// trapezium; velocity-based: the highest velocity and acceleration. 0 is no limit.
Profile Servo::profile(double distance) const {
  const auto velocity = static_cast<double>(table_.get(profile_velocity));
  const auto acceleration = static_cast<double>(table_.get(profile_acceleration));
  Profile result{infinity, infinity};
  if (table_.get(drive_mode) != time_based_profile) {
    if (velocity > 0) result.speed = velocity * velocity_unit;
    if (acceleration > 0) result.acceleration = acceleration * acceleration_unit;
  } else if (velocity > 0) {
    const double whole = velocity / 1000;
    const double speeding_up = std::min(acceleration / 1000, whole / 2);
    result.speed = distance / (whole - speeding_up);
    if (speeding_up > 0) result.acceleration = std::max(result.speed, std::abs(motion_.velocity())) / speeding_up;
  }
  result.speed = std::min(result.speed, settings_.speed);
  return result;
}

Time Servo::stated_duration(double distance) const {
  const auto velocity = static_cast<double>(table_.get(profile_velocity));
  if (velocity == 0) return Time::zero();
  if (table_.get(drive_mode) == time_based_profile) return from_seconds(velocity / 1000);
  return from_seconds(std::abs(distance) / (velocity * velocity_unit));
}

bool Servo::at_rest() const {
  return !torque() || (motion_.at_goal() && table_.get(bus_watchdog) <= 0);
}

void Servo::follow(Time time) {
  now_ = time;
  if (!torque()) return;
  const auto watchdog = table_.get(bus_watchdog);
  if (watchdog > 0 && time - heard_ > watchdog * watchdog_unit) {
    motion_.stop();
    table_.set(profile_acceleration, 0);
    table_.set(profile_velocity, 0);
    table_.set(bus_watchdog, watchdog_error);
  }
  if (!motion_.at_goal()) motion_.follow();
}

void Servo::refresh() {
  const double velocity = motion_.velocity();
  const double effort = std::isfinite(settings_.speed) ? std::clamp(velocity / settings_.speed, -1.0, 1.0) : 0.0;
  constexpr double current_at_full_speed = 60;  // of 2.69 mA, without load
  constexpr double full_pwm = 885;
  const auto position = std::lround(motion_.position());
  table_.set(present_position, position);
  table_.set(position_trajectory, position);
  table_.set(present_velocity, std::lround(velocity / velocity_unit));
  table_.set(velocity_trajectory, std::lround(velocity / velocity_unit));
  table_.set(present_current, std::lround(effort * current_at_full_speed));
  table_.set(present_pwm, std::lround(effort * full_pwm));
  table_.set(moving, velocity != 0 ? 1 : 0);
  constexpr int in_position = 1 << 0;
  constexpr int profile_ongoing = 1 << 1;
  table_.set(moving_status, !torque() ? 0 : motion_.at_goal() ? in_position : profile_ongoing);
  table_.set(realtime_tick, now_ / tick % 32768);
}

nlohmann::json Servo::state() const {
  return {{"on", torque()},
          {"position", motion_.position()},
          {"target", table_.get(goal_position)},
          {"velocity", motion_.velocity()},
          {"overloaded", overloaded_},
          {"shut_down", shut_down_}};
}

}  // namespace lamprey::robot_bridge::emulators::dynamixel
