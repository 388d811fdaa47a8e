#include "robot_bridge/command_gate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

namespace lamprey::robot_bridge {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

class Gate : public ::testing::Test {
 protected:
  Gate() { token_ = claims_.claim(7, 0, now_).token; }

  messaging::ServoCommand command(std::uint64_t evaluation, std::uint32_t time_step, bool last = false) const {
    messaging::ServoCommand command;
    command.token = token_;
    command.evaluation = evaluation;
    command.time_step = time_step;
    command.last = last;
    command.position.fill(10);
    return command;
  }
  CommandGate::Decision look(const messaging::ServoCommand& command) { return gate_.look(command, claims_, now_); }
  /// Through the gate and made.
  void make(std::uint64_t evaluation, std::uint32_t time_step, bool last = false) {
    ASSERT_TRUE(look(command(evaluation, time_step, last)).accepted);
    gate_.step_done(now_);
  }

  Clock::time_point now_{1h};
  Claims claims_{0, 2s};
  std::uint64_t token_ = 0;
  CommandGate gate_{200ms};
};

TEST_F(Gate, LetsTheStepsOfAnEvaluationThroughOneAfterTheOther) {
  for (std::uint32_t step = 0; step < 100; ++step) make(1, step, step == 99);
  EXPECT_FALSE(gate_.evaluating());
  EXPECT_EQ(gate_.counters().accepted, 100U);
  EXPECT_EQ(gate_.counters().voided, 0U);
  make(2, 0);
}

TEST_F(Gate, RefusesWhatIsNotUnderTheClaimInForce) {
  auto old = command(1, 0);
  --old.token;
  auto forged = command(1, 0);
  ++forged.token;
  for (const auto& refused : {old, forged}) {
    const auto decision = look(refused);
    EXPECT_FALSE(decision.accepted);
    EXPECT_TRUE(decision.voided.empty());
  }
  EXPECT_EQ(gate_.counters().under_no_claim, 2U);
  now_ += 2s;  // the claim has expired
  EXPECT_FALSE(look(command(1, 0)).accepted);
  EXPECT_EQ(gate_.counters().under_no_claim, 3U);
}

TEST_F(Gate, AnEvaluationThatMissesAStepIsVoid) {
  make(1, 0);
  const auto decision = look(command(1, 2));
  EXPECT_FALSE(decision.accepted);
  EXPECT_THAT(decision.voided, HasSubstr("step 1 has not come"));
  EXPECT_FALSE(look(command(1, 1)).accepted) << "it stays void";
  EXPECT_EQ(gate_.counters().voided, 1U);
  make(2, 0);
}

TEST_F(Gate, AnEvaluationThatDoesNotBeginWithItsFirstStepIsVoid) {
  EXPECT_THAT(look(command(1, 5)).voided, HasSubstr("begins with step 5"));
}

TEST_F(Gate, ARepeatedStepMovesNothingAndHarmsNothing) {
  make(1, 0);
  make(1, 1);
  for (const std::uint32_t step : {0U, 1U}) {
    const auto decision = look(command(1, step));
    EXPECT_FALSE(decision.accepted);
    EXPECT_TRUE(decision.voided.empty());
  }
  EXPECT_EQ(gate_.counters().repeated, 2U);
  make(1, 2);
}

TEST_F(Gate, AStepThatComesBeforeTheOneBeforeIsOverVoidsTheEvaluation) {
  ASSERT_TRUE(look(command(1, 0)).accepted);
  EXPECT_THAT(look(command(1, 1)).voided, HasSubstr("before the one before it was over"));
}

TEST_F(Gate, AStepThatIsLateVoidsTheEvaluation) {
  make(1, 0);
  EXPECT_FALSE(gate_.overdue(now_ + 199ms));
  const auto reason = gate_.overdue(now_ + 200ms);
  ASSERT_TRUE(reason);
  EXPECT_EQ(*reason, "step 1 has not come within 200 ms");
  EXPECT_FALSE(gate_.overdue(now_ + 1h)) << "once";
  EXPECT_FALSE(look(command(1, 1)).accepted);
}

TEST_F(Gate, NothingIsLateBetweenEvaluations) {
  make(1, 0);
  make(1, 1, true);
  EXPECT_FALSE(gate_.overdue(now_ + 1h));
}

TEST_F(Gate, WhatIsNoNumberVoidsTheEvaluation) {
  for (const double nonsense : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto bad = command(gate_.evaluation() + 1, 0);
    bad.position[3] = nonsense;
    const auto decision = look(bad);
    EXPECT_FALSE(decision.accepted);
    EXPECT_THAT(decision.voided, HasSubstr("no number"));
  }
  EXPECT_EQ(gate_.counters().not_numbers, 2U);
}

TEST_F(Gate, EachClaimCountsItsEvaluationsAnew) {
  make(9, 0);
  now_ += 2s;
  token_ = claims_.claim(8, 0, now_).token;
  make(1, 0);
  EXPECT_EQ(gate_.token(), token_);
}

}  // namespace
}  // namespace lamprey::robot_bridge
