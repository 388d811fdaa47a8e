#include "science/problems/controlled_quadruped.hpp"
#include "science/robots/quadruped.hpp"
#include "tests/storage/support.hpp"

#include <gmock/gmock.h>

namespace lamprey::storage::testing {
namespace {

using ::testing::ElementsAre;
using Rows = std::vector<std::vector<std::string>>;

class RobotViewsTest : public ::testing::Test {
 protected:
  /// A job's outcome by what the gap is about: initial total, then cycle and total of each accepted change.
  static experiment::Outcome outcome(double initial, const std::vector<std::pair<std::uint32_t, double>>& changes) {
    experiment::Outcome made;
    made.cycles = 100;
    const auto score = [](double total) { return experiment::Score{total / 2, total / 4, total / 8, total}; };
    made.initial = made.final = made.highest = made.evolved = score(initial);
    for (const auto& [cycle, total] : changes) {
      made.trace.push_back({cycle, score(total)});
      made.final = score(total);
      if (total > made.highest.total) made.highest = made.final;
    }
    made.accepted = static_cast<std::uint32_t>(changes.size());
    return made;
  }

  std::int64_t row(const SweepCase& sweep) { return store_.add_sweep(sweep.what).sweep.row; }

  void store_done(const SweepCase& sweep, std::uint64_t job, const experiment::Outcome& made) {
    store_.commit({.jobs = {done_job(sweep, row(sweep), job, made)}});
  }

  /// A sweep of one cell, on the ground given or on a robot.
  static SweepCase one_job(const std::string& name, const std::string& robot, double push_factor = 1,
                           std::uint64_t seed = 9, const std::string& mutation = "all", int cycles = 1000) {
    idl::SweepSpecification specification;
    specification.set_name(name);
    specification.set_seed(seed);
    specification.set_replicates(1);
    const auto set = [&](const std::string& parameter) {
      auto* setting = specification.add_base();
      setting->set_parameter(parameter);
      return setting->mutable_value();
    };
    set("robot")->set_text(robot);
    set("mutation")->set_text(mutation);
    set("cycles")->set_integer(cycles);
    if (robot == "quadruped") set("push_factor")->set_real(push_factor);
    return sweep_case(specification);
  }

  Rows rows(const std::string& sql) { return ResultsReader(path_).query(sql).rows; }
  Rows twins() { return rows("SELECT sweep, job, simulated_sweep, simulated_job FROM gap ORDER BY 1, 2"); }

  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
  ResultsStore store_{path_};
};

TEST_F(RobotViewsTest, RecordingsHasARowPerAttempt) {
  const auto sweep = robot_sweep("robots");
  auto second = made_up_recording(8);
  second.tries.clear();
  store_.commit({.jobs = {done_job(sweep, row(sweep), 1)},
                 .recordings = {{row(sweep), 1, 0xfedcba9876543210, JobState::done, true, made_up_recording(7)},
                                {row(sweep), 1, 5, JobState::failed, false, second}}});
  EXPECT_EQ(rows("SELECT sweep, job, attempt, robot, token, worker, state, accepted, evaluations, voided, time_steps, "
                 "measured FROM recordings ORDER BY attempt"),
            (Rows{{"\"robots\"", "1", "1", "\"lamprey-1\"", "47", "\"fedcba9876543210\"", "\"done\"", "1", "2", "1",
                   "7", "1"},
                  {"\"robots\"", "1", "2", "\"lamprey-1\"", "48", "\"0000000000000005\"", "\"failed\"", "0", "0", "0",
                   "0", "null"}}));
  EXPECT_EQ(rows("SELECT ended LIKE '20__-__-__T__:__:__Z' FROM recordings")[0][0], "1");
}

TEST_F(RobotViewsTest, MotionHasPositionsInUnitsServoByServo) {
  const auto sweep = robot_sweep("robots");
  RobotRecording recording{.robot = "r", .token = 1, .tries = {{.evaluation = 0, .attempt = 0, .voided = "late"}}};
  recording.tries.push_back({.evaluation = 0,
                             .attempt = 1,
                             .commanded = {1000, 1100, 1200, 1300, 1400, 1500, 1600, 1700,  //
                                           0, 3000, -25, 1, 2, 3, 4, 5},
                             .reported = {1, 2, 3, 4, 5, 6, 7, 8, 1050, 12, 13, 14, 15, 16, 17, -150},
                             .feet_down = {9, 6}});
  store_.commit({.recordings = {{row(sweep), 3, 5, JobState::failed, false, recording}}});
  const auto names = science::problems::servo_names();
  for (std::size_t step = 0; step < 2; ++step) {
    for (std::size_t servo = 0; servo < robot_servos; ++servo) {
      const auto found = rows(
          "SELECT sweep, job, attempt, evaluation, try, counts, round(100 * commanded), round(100 * reported) FROM "
          "motion WHERE step = " +
          std::to_string(step) + " AND servo = '" + names[servo] + "'");
      const auto at = robot_servos * step + servo;
      EXPECT_EQ(found, (Rows{{"\"robots\"", "3", "1", "0", "1", "1", std::to_string(recording.tries[1].commanded[at]),
                              std::to_string(recording.tries[1].reported[at])}}))
          << step << names[servo];
    }
  }
  EXPECT_EQ(rows("SELECT commanded, reported FROM motion WHERE step = 1 AND servo = 'front left vertical'"),
            (Rows{{"0", "10.5"}}));
  EXPECT_EQ(rows("SELECT count(*) FROM motion")[0][0], "16");
}

TEST_F(RobotViewsTest, MotionHasTheFootOfTheServosLeg) {
  const auto sweep = robot_sweep("robots");
  RobotRecording recording{.robot = "r", .token = 1, .tries = {{}}};
  constexpr std::size_t rows_of_try = 16;  // every set of feet
  auto& tried = recording.tries[0];
  for (std::int32_t feet = 0; feet < static_cast<std::int32_t>(rows_of_try); ++feet) tried.feet_down.push_back(feet);
  tried.commanded.assign(rows_of_try * robot_servos, 1000);
  tried.reported = tried.commanded;
  store_.commit({.recordings = {{row(sweep), 3, 5, JobState::failed, false, recording}}});
  const auto names = science::problems::servo_names();
  for (std::size_t leg = 0; leg < robot_legs; ++leg) {
    for (const auto servo : {science::robots::vertical_servo(leg), science::robots::horizontal_servo(leg)}) {
      EXPECT_EQ(rows("SELECT count(*), count(*) FILTER (WHERE foot_down = (step >> " + std::to_string(leg) +
                     ") & 1) FROM motion WHERE servo = '" + names[servo] + "'"),
                (Rows{{"16", "16"}}))
          << names[servo];
    }
  }
}

TEST_F(RobotViewsTest, GapIsTheRobotsLessTheSimulatedOne) {
  const auto sweep = robot_sweep("robots");
  // Totals:        cycle  -     0    5    7    20
  //   on the robot       40              64   56
  //   in simulation      48    72   64        80
  // differ by                  32   24   0    24: the initial ones have gone when the first cycle ends.
  store_done(sweep, 0, outcome(40, {{7, 64}, {20, 56}}));
  store_done(sweep, 4, outcome(48, {{0, 72}, {5, 64}, {20, 80}}));
  store_.commit({.recordings = {{row(sweep), 0, 0xfedcba9876543210, JobState::done, true, made_up_recording(1)},
                                {row(sweep), 0, 7, JobState::failed, false, made_up_recording(2)}}});
  EXPECT_EQ(rows("SELECT sweep, job, robot, simulated_sweep, simulated_job, stability, distance, fuel, total, "
                 "highest_total, trace_distance FROM gap"),
            (Rows{{"\"robots\"", "0", "\"lamprey-1\"", "\"robots\"", "4", "-12", "-6", "-3", "-24", "-16", "32"}}));
}

TEST_F(RobotViewsTest, TraceDistanceCarriesBothForwardFromTheirInitialTotals) {
  const auto distance = [&](const experiment::Outcome& on_robot, const experiment::Outcome& simulated) {
    const auto sweep = robot_sweep("robots-" + std::to_string(store_.sweeps().size()));
    store_done(sweep, 0, on_robot);
    store_done(sweep, 4, simulated);
    return rows("SELECT trace_distance FROM gap WHERE sweep = '" + sweep.what.name + "'")[0][0];
  };
  EXPECT_EQ(distance(outcome(40, {}), outcome(48, {})), "8");
  EXPECT_EQ(distance(outcome(40, {}), outcome(40, {})), "0");
  EXPECT_EQ(distance(outcome(40, {{3, 100}}), outcome(48, {})), "52");
  EXPECT_EQ(distance(outcome(40, {}), outcome(48, {{99, 41}})), "8");
  // Both change in the first cycle: no cycle ends with what they began with.
  EXPECT_EQ(distance(outcome(0, {{0, 10}}), outcome(90, {{0, 11}})), "1");
  EXPECT_EQ(distance(outcome(0, {{0, 10}}), outcome(90, {{1, 11}})), "80");
  EXPECT_EQ(distance(outcome(5, {{1, 10}, {2, 30}, {3, 12}}), outcome(5, {{1, 11}, {3, 12}})), "19");
}

TEST_F(RobotViewsTest, GapFindsTheJobThatIsTheSameInSimulation) {
  const auto on_robot = one_job("on-robot", "bridge");
  store_done(on_robot, 0, outcome(40, {}));
  EXPECT_EQ(rows("SELECT * FROM gap"),
            (Rows{{"\"on-robot\"", "0", "null", "null", "null", "null", "null", "null", "null", "null", "null"}}));

  // None of these is: another seed, another cell, one that is not done.
  store_done(one_job("other-seed", "quadruped", 1, 10), 0, outcome(1, {}));
  store_done(one_job("other-mutation", "quadruped", 1, 9, "one"), 0, outcome(1, {}));
  store_done(one_job("other-cycles", "quadruped", 1, 9, "all", 999), 0, outcome(1, {}));
  const auto failed = one_job("failed", "quadruped", 0.25);
  store_.commit({.jobs = {ended_job(failed, row(failed), 0, JobState::failed, "x")}});
  EXPECT_EQ(twins(), (Rows{{"\"on-robot\"", "0", "null", "null"}}));

  // The robot has no push factor: any will do, the default before another.
  store_done(one_job("slippery", "quadruped", 0.5), 0, outcome(32, {}));
  EXPECT_EQ(twins(), (Rows{{"\"on-robot\"", "0", "\"slippery\"", "0"}}));
  EXPECT_EQ(rows("SELECT total FROM gap")[0][0], "8");
  store_done(one_job("flat", "quadruped"), 0, outcome(16, {}));
  EXPECT_EQ(twins(), (Rows{{"\"on-robot\"", "0", "\"flat\"", "0"}}));
  EXPECT_EQ(rows("SELECT total FROM gap")[0][0], "24");
}

TEST_F(RobotViewsTest, GapPrefersTheJobOfTheSameSweepAndKeepsCellsApart) {
  const auto earlier = robot_sweep("earlier");
  for (std::uint64_t job = 4; job < 8; ++job) store_done(earlier, job, outcome(1, {}));
  const auto sweep = robot_sweep("robots");
  for (const std::uint64_t job : {0U, 1U, 2U, 3U, 4U, 6U}) store_done(sweep, job, outcome(2, {}));
  EXPECT_EQ(twins(), (Rows{{"\"robots\"", "0", "\"robots\"", "4"},
                           {"\"robots\"", "1", "\"earlier\"", "5"},
                           {"\"robots\"", "2", "\"robots\"", "6"},
                           {"\"robots\"", "3", "\"earlier\"", "7"}}));
}

TEST_F(RobotViewsTest, GapKeepsReplicatesApart) {
  auto specification = robot_sweep("robots").specification;
  specification.set_replicates(2);
  const auto sweep = sweep_case(specification);
  std::uint64_t on_robot = 0;
  for (std::uint64_t job = 0; job < sweep.grid.jobs(); ++job) {
    const auto made = sweep.grid.job(job);
    if (made.parameters.choice("robot") == "bridge") {
      ++on_robot;
    } else if (made.replicate == 0) {
      continue;
    }
    store_done(sweep, job, outcome(2, {}));
  }
  EXPECT_EQ(on_robot, 8U);
  EXPECT_EQ(rows("SELECT a.replicate, a.mutation = b.mutation AND a.acceptance = b.acceptance, b.replicate, count(*) "
                 "FROM gap AS g JOIN result AS a ON a.job = g.job LEFT JOIN result AS b ON b.job = g.simulated_job "
                 "GROUP BY 1, 2, 3"),
            (Rows{{"0", "null", "null", "4"}, {"1", "1", "1", "4"}}));
}

TEST_F(RobotViewsTest, ResultsOfARobotArePhysical) {
  const auto sweep = robot_sweep("robots");
  store_done(sweep, 1, outcome(1, {}));
  store_done(sweep, 5, outcome(1, {}));
  store_.commit({.jobs = {ended_job(sweep, row(sweep), 2, JobState::failed, "x")}});
  EXPECT_THAT(rows("SELECT job, robot, repeatability, push_factor FROM result ORDER BY job"),
              ElementsAre(ElementsAre("1", "\"bridge\"", "\"physical\"", "null"),
                          ElementsAre("2", "\"bridge\"", "null", "null"),
                          ElementsAre("5", "\"quadruped\"", "\"bitwise\"", "1")));
}

}  // namespace
}  // namespace lamprey::storage::testing
