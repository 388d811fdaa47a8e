#pragma once

#include "robot_bridge/drivers/dynamixel_protocol.hpp"
#include "robot_bridge/drivers/serial_driver.hpp"

#include <span>
#include <string>
#include <vector>

namespace lamprey::robot_bridge::drivers {

/// Dynamixel servos of the X series, in position control mode, which tell where they are.
///
/// A move is one sync write of each servo's goal and of the time in which it shall be reached, so that all end
/// together: `enable` sets bit 2 of the drive mode (time-based profile), and `connect` sets the return delay time to 0,
/// of servos whose torque is off. They keep both without power, and so are written only where they are not so already.
///
/// A servo that reports an alert makes all calls fail but `connect`, `hold` and `release`, which take the others to
/// rest.
class DynamixelDriver final : public SerialDriver {
 public:
  DynamixelDriver(const Calibration& calibration, std::string port);

  std::string description() const override;
  /// With the return delay times that `connect` has found.
  double highest_rate() const override;

 protected:
  void greet() override;
  std::optional<Pose> locate() override;
  /// Servos that are off are told to stay where they are just now, whatever `start` says; then they get their torque.
  /// Refused where a servo has torque but no time-based profile.
  void turn_on(const Pose& start) override;
  void begin_move(std::chrono::microseconds duration) override;
  Feedback sense() override;
  bool ask_whether_moving() override;
  void stop() override;
  void send_release() override;
  void confirm_release() override;

 private:
  enum class Alerts : bool { are_errors, are_left };

  dynamixel::StatusPacket exchange(const dynamixel::Octets& instruction, std::uint8_t id, std::size_t parameters,
                                   const std::string& who, Alerts alerts = Alerts::are_errors);
  std::vector<std::uint32_t> read_all(dynamixel::Register what, Alerts alerts = Alerts::are_errors);
  dynamixel::StatusPacket next_status(std::uint8_t id, std::size_t parameters, const std::string& who,
                                      SerialLine::Deadline deadline);
  void send(const dynamixel::Octets& instruction);
  void write_all(dynamixel::Register what, std::uint32_t value);
  void write_one(std::size_t servo, dynamixel::Register what, std::uint32_t value, Alerts alerts = Alerts::are_errors);
  void throw_if_error(const dynamixel::StatusPacket& status, const std::string& who, Alerts alerts);

  std::vector<std::int32_t> positions(Alerts alerts = Alerts::are_errors);
  Pose pose_of(const std::vector<std::int32_t>& ticks) const;
  void write_goals(std::span<const std::int32_t> ticks, std::uint32_t milliseconds);
  std::size_t octets_per_step() const;

  const std::vector<std::uint8_t> ids_;
  dynamixel::StatusDecoder decoder_;
  std::array<std::uint32_t, servos> return_delay_{};  ///< units of 2 µs
  std::string alerts_;                                ///< what `connect` has found, for the description
};

}  // namespace lamprey::robot_bridge::drivers
