#include "robot_bridge/step_rhythm.hpp"

#include <algorithm>
#include <cstdint>

namespace lamprey::robot_bridge {
namespace {

using std::chrono::nanoseconds;

/// What is left of a period after the question where the servos are: enough for its answer, and for two more questions.
constexpr std::chrono::milliseconds time_for_more_questions{7};

nanoseconds share(nanoseconds period, double part) {
  return nanoseconds(static_cast<std::int64_t>(static_cast<double>(period.count()) * part));
}

}  // namespace

StepRhythm step_rhythm(DeviceFamily family, double rate) {
  using std::chrono::milliseconds;
  const nanoseconds period(static_cast<std::int64_t>(1e9 / rate));
  const auto rhythm = [&](nanoseconds move, nanoseconds read) {
    return StepRhythm{
        .period = period, .move = move, .read = read, .asks_whether_moving = period - read >= time_for_more_questions};
  };
  switch (family) {
    case DeviceFamily::ssc32:
      // The 61 octets of a move take a quarter of a period of 20 ms at 115200 baud, the question for positions and
      // contacts another: the move has to be over when the question arrives, and its answer early enough to be
      // answered in turn. Where there is time, late: an input tells of a contact 15 ms after it has closed.
      return rhythm(share(period, 0.3), std::max<nanoseconds>(share(period, 0.55), period - milliseconds(12)));
    case DeviceFamily::dynamixel:
      // The goals are there within 0.6 ms. The servos' own time is long enough for a smooth move, and short enough that
      // they have arrived for certain when they are asked where they are.
      return rhythm(share(period, 0.4), std::max<nanoseconds>(share(period, 0.35), period - milliseconds(8)));
    case DeviceFamily::mock:
      break;
  }
  return rhythm(period, nanoseconds(0));
}

}  // namespace lamprey::robot_bridge
