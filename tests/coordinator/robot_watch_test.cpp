#include "coordinator/robot_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::coordinator {
namespace {

using messaging::RobotState;
using messaging::RobotStatus;
using std::chrono::seconds;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class RobotWatchTest : public testing::Test {
 protected:
  RobotWatchTest() {
    status.robot = 7;
    status.name = "bench";
    status.state = RobotState::inactive;
    status.incarnation = 1;
    status.driver = "ssc32";
    status.host = "laboratory";
    status.counters = {{"steps", 3}, {"evaluations_voided", 0}};
  }

  RobotStatus status;
  RobotWatch watch;
  RobotWatch::Clock::time_point now{seconds{100}};

  std::vector<RobotEvent> heard() { return watch.heard(status, now); }
};

TEST_F(RobotWatchTest, TellsOfARobotOnce) {
  EXPECT_THAT(heard(), ElementsAre(RobotEvent{"robot_joined", "bench: ssc32 on laboratory"},
                                   RobotEvent{"robot_inactive", "bench"}));
  EXPECT_THAT(heard(), IsEmpty());
}

TEST_F(RobotWatchTest, TellsOfEachStateWithItsReason) {
  heard();
  status.state = RobotState::active;
  EXPECT_THAT(heard(), ElementsAre(RobotEvent{"robot_active", "bench"}));
  status.state = RobotState::fault;
  status.reason = "no answer within 20 ms";
  EXPECT_THAT(heard(), ElementsAre(RobotEvent{"robot_fault", "bench: no answer within 20 ms"}));
}

TEST_F(RobotWatchTest, TellsOfAnEmergencyStopAndItsReset) {
  heard();
  status.stopped = true;
  status.reason = "smoke";
  EXPECT_THAT(heard(), ElementsAre(RobotEvent{"robot_stopped", "bench: smoke"}));
  status.stopped = false;
  status.reason.clear();
  EXPECT_THAT(heard(), ElementsAre(RobotEvent{"robot_reset", "bench"}));
}

TEST_F(RobotWatchTest, ALatchedStopIsToldOfWithTheRobot) {
  status.stopped = true;
  status.reason = "smoke";
  EXPECT_THAT(heard(), ElementsAre(RobotEvent{"robot_joined", "bench: ssc32 on laboratory"},
                                   RobotEvent{"robot_inactive", "bench"}, RobotEvent{"robot_stopped", "bench: smoke"}));
}

TEST_F(RobotWatchTest, SumsUpVoidEvaluations) {
  heard();
  status.counters[1].value = 1;
  EXPECT_THAT(heard(), ElementsAre(RobotEvent{"robot_evaluations_voided", "bench: 1"}));
  now += seconds{1};
  status.counters[1].value = 5;
  EXPECT_THAT(heard(), IsEmpty()) << "the next ten seconds are told of together";
  now += seconds{10};
  status.counters[1].value = 7;
  EXPECT_THAT(heard(), ElementsAre(RobotEvent{"robot_evaluations_voided", "bench: 6"}));
}

TEST_F(RobotWatchTest, ABridgeStartedAgainCountsFromNothing) {
  status.counters[1].value = 9;
  heard();
  status.incarnation = 2;
  status.counters[1].value = 1;
  EXPECT_THAT(heard(), ElementsAre(RobotEvent{"robot_joined", "bench: ssc32 on laboratory, again"},
                                   RobotEvent{"robot_evaluations_voided", "bench: 1"}));
}

TEST_F(RobotWatchTest, ARobotThatLeavesMayComeBack) {
  heard();
  status.state = RobotState::finalized;
  EXPECT_THAT(heard(), ElementsAre(RobotEvent{"robot_left", "bench"}));
  EXPECT_THAT(heard(), IsEmpty());
  status.state = RobotState::inactive;
  EXPECT_EQ(heard().size(), 2U);
}

TEST_F(RobotWatchTest, SilenceIsToldOfOnce) {
  heard();
  now += seconds{4};
  EXPECT_THAT(watch.fallen_silent(now), IsEmpty());
  now += seconds{1};
  EXPECT_THAT(watch.fallen_silent(now), ElementsAre(RobotEvent{"robot_lost", "bench"}));
  EXPECT_THAT(watch.fallen_silent(now), IsEmpty());
}

TEST_F(RobotWatchTest, TwoBridgesOfOneNameFillNoLog) {
  std::size_t told = heard().size();
  std::string last;
  for (int turn = 0; turn < 1000; ++turn) {
    status.incarnation = 3 - status.incarnation;
    for (const auto& event : heard()) {
      ++told;
      last = event.kind;
    }
  }
  EXPECT_LT(told, 30U);
  EXPECT_EQ(last, "robot_unsteady");
}

TEST_F(RobotWatchTest, NamesFromTheNetworkAreMadePrintable) {
  status.name = "be\x1b[2Jnch";
  for (const auto& event : heard()) EXPECT_EQ(event.text.find('\x1b'), std::string::npos) << event.text;
}

TEST_F(RobotWatchTest, FollowsSoManyRobotsOnly) {
  for (std::uint64_t robot = 1; robot <= 2 * RobotWatch::most_robots; ++robot) {
    status.robot = robot;
    EXPECT_EQ(heard().empty(), robot > RobotWatch::most_robots);
  }
}

}  // namespace
}  // namespace lamprey::coordinator
