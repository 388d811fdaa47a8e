#include "robot_bridge/emulators/ssc32/channel.hpp"

#include <algorithm>

namespace lamprey::robot_bridge::emulators::ssc32 {

double Channel::pulse(Time time) const {
  if (time >= end_) return to_;
  return from_ + (to_ - from_) * (in_seconds(time - start_) / in_seconds(end_ - start_));
}

bool Channel::at_rest(Time time) const {
  return !on_ || (time >= end_ && (stalled_ || position_ == to_));
}

void Channel::move(double target, Time start, Time duration) {
  from_ = on_ ? pulse(start) : target;
  to_ = target;
  start_ = start;
  end_ = on_ ? start + duration : start;
  on_ = true;
}

void Channel::stop(Time time) {
  if (on_) move(pulse(time), time, Time::zero());
}

void Channel::follow(Time time) {
  if (!on_ || stalled_) return;
  const double reach = speed_ * in_seconds(tick);
  const double goal = pulse(time);
  position_ = std::clamp(goal, position_ - reach, position_ + reach);
}

}  // namespace lamprey::robot_bridge::emulators::ssc32
