#include "science/networks/timed_loop.hpp"

#include "tests/science/networks/output_text.hpp"

#include <gtest/gtest.h>
#include <string>

namespace lamprey::science::networks {
namespace {

std::string outputs(const LoopTimes& times, int period, int time_steps) {
  TimedLoop loop{.period = period};
  loop.servo_times[3] = times;
  TimedLoopState state;
  return output_text(whole_steps(loop), state, time_steps)[3];
}

TEST(TimedLoop, SwitchesAServoForwardAndBackwardInEveryRound) {
  EXPECT_EQ(outputs({1, 2, 5, 3}, 10, 20), "0++00---000++00---00");
}

TEST(TimedLoop, AServoSwitchedBothWaysStandsStill) {
  EXPECT_EQ(outputs({0, 4, 2, 4}, 8, 8), "++00--00");
}

TEST(TimedLoop, TheLoopsEndSwitchesEverythingOff) {
  EXPECT_EQ(outputs({6, 9, 0, 0}, 8, 16), "000000++000000++");
  EXPECT_EQ(outputs({8, 9, 0, 0}, 8, 16), "0000000000000000");
}

TEST(TimedLoop, TimesAreRoundedDown) {
  EXPECT_EQ(outputs({1.9, 2.9, 5.5, 1.01}, 8, 8), "0++00-00");
}

}  // namespace
}  // namespace lamprey::science::networks
