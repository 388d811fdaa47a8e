#pragma once

#include "robot_bridge/emulators/time.hpp"

namespace lamprey::robot_bridge::emulators::ssc32 {

/// A servo without feedback, and the pulse that the controller gives it: the pulse moves evenly from one target to the
/// next, and the servo follows it as fast as it can. In µs of pulse width.
class Channel {
 public:
  /// The servo stands at `position`, off, and follows with at most `speed` µs per second (infinity: at once).
  Channel(double position, double speed) : position_(position), speed_(speed) {}

  bool on() const { return on_; }
  /// The present pulse, of a channel that is on.
  double pulse(Time time) const;
  double target() const { return to_; }
  /// Where the servo's arm is.
  double position() const { return position_; }
  bool stalled() const { return stalled_; }
  /// Neither the pulse nor the servo moves on by itself.
  bool at_rest(Time time) const;

  /// From off, the pulse jumps to the target, whatever `duration` says.
  void move(double target, Time start, Time duration);
  /// The pulse stays where it is.
  void stop(Time time);
  void turn_off() { on_ = false; }
  void stall(bool on) { stalled_ = on; }
  /// By hand; only while it is off.
  void place(double position) { position_ = position; }

  /// Lets the servo follow the pulse of `time` for the tick that ends then.
  void follow(Time time);

 private:
  bool on_ = false;
  bool stalled_ = false;
  double from_ = 0;
  double to_ = 0;
  Time start_{};
  Time end_{};
  double position_;
  double speed_;
};

}  // namespace lamprey::robot_bridge::emulators::ssc32
