#pragma once

namespace lamprey::robot_bridge::emulators::dynamixel {

/// How fast a servo goes to its goal; infinity where nothing limits it. In ticks and seconds.
struct Profile {
  double speed;
  double acceleration;
};

/// A servo's motion: speeds up, cruises and slows down as its profile and its motor allow.
class Motion {
 public:
  explicit Motion(double position) : position_(position), goal_(position) {}

  double position() const { return position_; }
  double velocity() const { return velocity_; }  ///< ticks per second
  double goal() const { return goal_; }
  bool at_goal() const { return position_ == goal_ && velocity_ == 0; }

  void go_to(double goal, const Profile& profile);
  /// Stands where it is.
  void stop();
  /// By hand.
  void place(double position);
  /// Passes one tick.
  void follow();

 private:
  double position_;
  double velocity_ = 0;
  double goal_;
  Profile profile_{};
};

}  // namespace lamprey::robot_bridge::emulators::dynamixel
