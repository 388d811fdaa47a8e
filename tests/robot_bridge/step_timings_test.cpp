#include "robot_bridge/step_timings.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace lamprey::robot_bridge {
namespace {

using namespace std::chrono_literals;

TEST(StepTimings, AreKeptByTheStepsNumber) {
  StepTimings timings;
  timings.add(0, 5us, 100us);
  timings.add(2, 7us, 200us);
  timings.add(2, 9us, 300us);
  timings.add_jitter(2, 11us, true);
  timings.add_jitter(2, 3us, false);
  EXPECT_EQ(to_csv(timings),
            "time_step,part,count,late,median,percentile_99,largest\n"
            "0,command_to_line,1,,5,5,5\n"
            "0,line_to_state,1,,100,100,100\n"
            "0,jitter,0,0,0,0,0\n"
            "1,command_to_line,0,,0,0,0\n"
            "1,line_to_state,0,,0,0,0\n"
            "1,jitter,0,0,0,0,0\n"
            "2,command_to_line,2,,7,9,9\n"
            "2,line_to_state,2,,207,300,300\n"
            "2,jitter,2,1,3,11,11\n");
}

TEST(StepTimings, HaveABoundWhateverIsAskedFor) {
  StepTimings timings;
  timings.add(std::numeric_limits<std::uint32_t>::max(), 1us, 1us);
  timings.add(StepTimings::most_steps, 2us, 1us);
  ASSERT_EQ(timings.steps().size(), StepTimings::most_steps);
  EXPECT_EQ(timings.steps().back().command_to_line.count(), 2U);
}

}  // namespace
}  // namespace lamprey::robot_bridge
