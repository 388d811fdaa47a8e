#pragma once

#include "robot_bridge/calibration.hpp"
#include "robot_bridge/driver.hpp"
#include "robot_bridge/drivers/sent_position.hpp"
#include "robot_bridge/drivers/serial_line.hpp"

#include <array>
#include <optional>
#include <string>

namespace lamprey::robot_bridge::drivers {

/// What drivers of devices on serial lines have in common: the line, which an error closes, and what was sent last.
class SerialDriver : public Driver {
 public:
  void connect() final;
  std::optional<Pose> present_position() final;
  void enable(const Pose& start) final;
  /// Refused before `enable`: servos that are off would jump.
  void move(const Pose& target, std::chrono::microseconds duration) final;
  Feedback read() final;
  bool moving() final;
  void hold() final;
  void release() final;
  bool let_go() noexcept final;
  void cancel() noexcept final { line_.cancel(); }

 protected:
  SerialDriver(const Calibration& calibration, std::string port);

  // What the interface's calls do on an open line. Before `greet` nothing is known of the device.
  virtual void greet() = 0;
  virtual std::optional<Pose> locate() = 0;
  virtual void turn_on(const Pose& start) = 0;
  /// What to send is in `sent`.
  virtual void begin_move(std::chrono::microseconds duration) = 0;
  virtual Feedback sense() = 0;
  virtual bool ask_whether_moving() = 0;
  virtual void stop() = 0;
  /// Is carried out by a device that hears it; nothing is answered.
  virtual void send_release() = 0;
  /// Throws where a servo is still on.
  virtual void confirm_release() = 0;

  const Calibration& calibration() const { return calibration_; }
  const Joint& joint(std::size_t servo) const { return calibration_.joints[servo]; }
  SerialLine& line() { return line_; }
  const SerialLine& line() const { return line_; }
  bool is_enabled() const { return enabled_; }

  /// Until when an answer must have come, where so many octets go over the wire before it ends.
  SerialLine::Deadline answer_deadline(std::size_t octets) const;

  /// A servo's goal; nothing where the device decides: before the first one, after a stop, where it is off.
  std::array<std::optional<SentPosition>, servos> sent;

 private:
  template <typename Body>
  auto call(const Body& body);

  const Calibration calibration_;
  SerialLine line_;
  bool enabled_ = false;
};

}  // namespace lamprey::robot_bridge::drivers
