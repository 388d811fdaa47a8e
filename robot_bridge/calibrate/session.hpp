#pragma once

#include "robot_bridge/calibration.hpp"
#include "robot_bridge/driver.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <istream>
#include <ostream>
#include <string>
#include <vector>

namespace lamprey::robot_bridge::calibrate {

/// A calibration to begin with where there is none yet: channels or ids in the order of the servos, the standing pose
/// and a range in the middle of what the device can.
Calibration first_draft(DeviceFamily family, std::int32_t baud);

/// The same joints with nothing but the device's own limits, so that a servo can be moved to where its limits are to
/// be. Unit 0 is the device's lowest number, unit 30 its highest.
Calibration whole_range(const Calibration& calibration);

enum class Ending : std::uint8_t { save, quit };

/// A talk with a person who moves servos one at a time and says where the leg stands and where its range ends: a
/// command a line from `in`, answers to `out`. Servos move slowly, only on command, one at a time; in the end they are
/// let go. One thread.
class Session {
 public:
  /// `driver` is of whole_range(begin). `interrupted`: asked while servos move.
  Session(Driver& driver, const Calibration& begin, std::istream& in, std::ostream& out,
          std::function<bool()> interrupted);

  /// Throws DriverError where the device fails at the beginning; later it is waited for.
  Ending run();

  /// As far as it has been marked; checked by whoever stores it.
  const Calibration& calibration() const { return calibration_; }

 private:
  using Words = std::vector<std::string>;

  bool turn_on();
  void prompt();
  bool obey(const Words& words);      ///< whether the talk goes on
  bool survives(const Words& words);  ///< the same, whatever the device does
  bool can_be_saved();                ///< else it says why a bridge would refuse it
  void mark(const std::string& what);
  void mark_units(const Words& words);
  void choose(const std::string& joint);
  void set_slew_rate(const Words& words);
  void go_to(double device);
  void let_go();
  void hold_again();
  void show();
  void present();
  double device_now() const;
  Joint& joint() { return calibration_.joints[chosen_]; }

  Driver& driver_;
  Calibration calibration_;
  Calibration range_;
  std::istream& in_;
  std::ostream& out_;
  std::function<bool()> interrupted_;
  Pose pose_{};  ///< in units of range_
  std::size_t chosen_ = 0;
  bool on_ = false;
  Ending ending_ = Ending::quit;
};

}  // namespace lamprey::robot_bridge::calibrate
