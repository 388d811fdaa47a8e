#pragma once

#include "robot_bridge/emulators/time.hpp"

namespace lamprey::robot_bridge::emulators::ssc32 {

/// A digital input with a pull-up; a closed contact pulls it low. It is looked at once per tick, and has changed when
/// the pin has been at another level for 15 ms without a break.
class DebouncedInput {
 public:
  /// The level at power-up needs no settling.
  explicit DebouncedInput(bool high = true) : high_(high), was_low_(!high) {}

  void look(bool pin_high) {
    ticks_ = pin_high == high_ ? 0 : ticks_ + 1;
    if (ticks_ * tick <= settling) return;
    high_ = pin_high;
    was_low_ = was_low_ || !high_;
    ticks_ = 0;
  }

  bool high() const { return high_; }

  /// Whether it has been high ever since this was asked last; asking starts anew.
  bool high_throughout() {
    const bool answer = !was_low_;
    was_low_ = !high_;
    return answer;
  }

  /// The pin is at the input's level.
  bool settled() const { return ticks_ == 0; }

 private:
  static constexpr Time settling = std::chrono::milliseconds{15};
  bool high_;
  bool was_low_;
  int ticks_ = 0;  ///< looks at the other level in a row
};

}  // namespace lamprey::robot_bridge::emulators::ssc32
