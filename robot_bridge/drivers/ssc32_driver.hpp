#pragma once

#include "robot_bridge/drivers/serial_driver.hpp"
#include "robot_bridge/drivers/ssc32_protocol.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lamprey::robot_bridge::drivers {

/// Lynxmotion's SSC-32 and SSC-32U: servos that are told where to go and don't tell where they are. What it knows of a
/// servo's position is the pulse that it sends, interpolated while it moves.
class Ssc32Driver final : public SerialDriver {
 public:
  Ssc32Driver(const Calibration& calibration, std::string port);

  std::string description() const override;
  double highest_rate() const override;

 protected:
  void greet() override;
  std::optional<Pose> locate() override;
  void turn_on(const Pose& start) override;
  void begin_move(std::chrono::microseconds duration) override;
  Feedback sense() override;
  bool ask_whether_moving() override;
  void stop() override;
  void send_release() override;
  void confirm_release() override;

 private:
  struct Answer {
    std::vector<std::int32_t> tens;  ///< by servo: its pulse in units of 10 µs, 0 where it is off
    std::vector<bool> inputs;        ///< whether high, by contact of `inputs_`
  };
  Answer ask(bool with_inputs);
  Answer ask_twice();
  void check(const std::vector<std::int32_t>& tens);
  double units_of(std::size_t servo, std::int32_t tens) const;
  void write(const std::string& text);
  std::vector<ssc32::ServoPulse> sent_pulses() const;

  const std::vector<std::int32_t> channels_;
  const std::vector<std::int32_t> inputs_;

  /// Between where a servo was seen last and where it has been sent since, in µs; unknown before it was enabled.
  struct Reach {
    std::int32_t lowest, highest;
  };
  std::array<std::optional<Reach>, servos> reach_;
  std::string version_;
};

}  // namespace lamprey::robot_bridge::drivers
