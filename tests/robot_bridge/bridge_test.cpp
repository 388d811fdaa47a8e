// A bridge with the mock robot, on the in-memory bus: its control loop is a real thread, so what is waited for is
// waited for until it happens.
#include "robot_bridge/bridge.hpp"

#include "messaging/in_memory/bus.hpp"
#include "messaging/robot/robot_asker.hpp"
#include "messaging/robot/robot_name.hpp"
#include "robot_bridge/drivers/mock_driver.hpp"

#include <filesystem>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

namespace lamprey::robot_bridge {
namespace {

using namespace std::chrono_literals;
using messaging::RobotReply;
using messaging::RobotRequest;
using messaging::RobotRequestKind;
using messaging::ServoCommand;
using messaging::ServoState;
using messaging::StepOutcome;
using ::testing::Each;
using ::testing::HasSubstr;

/// Whoever wants something from the robot, with a participant of its own.
struct Asker {
  Asker(messaging::in_memory::Bus& bus, std::uint64_t robot, std::uint64_t number)
      : participant(bus.join("asker")),
        asker(*participant, signal, robot, number),
        states(participant->reader<ServoState>(signal, messaging::Partition::of(robot))),
        commands(participant->writer<ServoCommand>(messaging::Partition::of(robot))) {}

  std::unique_ptr<messaging::Participant> participant;
  std::shared_ptr<messaging::Signal> signal = std::make_shared<messaging::Signal>();
  messaging::RobotAsker asker;
  std::unique_ptr<messaging::Reader<ServoState>> states;
  std::unique_ptr<messaging::Writer<ServoCommand>> commands;
};

class BridgeTest : public ::testing::Test {
 protected:
  BridgeTest() {
    std::filesystem::remove_all(folder_);
    start();
  }
  ~BridgeTest() override {
    end();
    std::filesystem::remove_all(folder_);
  }

  void start() {
    auto driver = std::make_unique<drivers::MockDriver>(calibration_);
    mock_ = driver.get();
    file_ = std::make_unique<StateFile>(folder_, "bench");
    control_ = std::make_unique<ControlLoop>(
        std::move(driver), calibration_, ControlOptions{.rate = rate_, .off_after = off_after_, .retry_interval = 10ms},
        signal_);
    BridgeOptions options;
    options.robot = "bench";
    options.driver = "mock";
    options.rate = rate_;
    options.grace = 500ms;
    options.emergency = emergency_participant_.get();
    bridge_ = std::make_unique<Bridge>(*participant_, signal_, *control_, *file_, options, Clock::now());
  }
  void end() {
    bridge_.reset();
    control_.reset();
    file_.reset();
  }

  void step() {
    signal_->wait_for(1ms);
    bridge_->step(Clock::now());
  }
  void until(const std::function<bool()>& condition) {
    const auto deadline = Clock::now() + 20s;
    while (!condition()) {
      ASSERT_LT(Clock::now(), deadline);
      step();
    }
  }

  RobotReply ask(RobotRequestKind kind, std::uint64_t token = 0, Asker* asker = nullptr) {
    RobotRequest request;
    request.kind = kind;
    request.token = token;
    request.position.fill(10);
    return ask(request, asker);
  }
  RobotReply ask(const RobotRequest& request, Asker* given = nullptr) {
    Asker& asker = given != nullptr ? *given : anne_;
    asker.asker.begin(request, Clock::now());
    RobotReply reply;
    until([&] {
      auto answer = asker.asker.poll(Clock::now());
      if (answer) reply = *answer;
      return answer.has_value();
    });
    return reply;
  }
  std::uint64_t claim() {
    until([&] { return control_->status().state == RobotState::inactive; });
    EXPECT_TRUE(ask(RobotRequestKind::activate).granted);
    const auto reply = ask(RobotRequestKind::claim);
    EXPECT_TRUE(reply.granted) << reply.reason;
    return reply.token;
  }

  ServoCommand command(std::uint64_t token, std::uint64_t evaluation, std::uint32_t time_step, double position) const {
    ServoCommand command;
    command.robot = robot_;
    command.token = token;
    command.evaluation = evaluation;
    command.time_step = time_step;
    command.position.fill(position);
    return command;
  }
  ServoState order(const ServoCommand& command) {
    EXPECT_TRUE(anne_.commands->write(command));
    ServoState state;
    until([&] {
      const auto states = anne_.states->take();
      if (!states.empty()) state = states.back();
      return !states.empty();
    });
    return state;
  }
  /// What is written is looked at by the bridge.
  void send(const ServoCommand& command, Asker& asker) {
    EXPECT_TRUE(asker.commands->write(command));
    bridge_->step(Clock::now());
  }
  /// A state may tell of what the control loop has counted since the step that published it began.
  std::uint64_t counter(const std::string& name) {
    bridge_->step(Clock::now());
    for (const auto& counter : bridge_->counters()) {
      if (counter.name == name) return counter.value;
    }
    ADD_FAILURE() << "no counter " << name;
    return 0;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("lamprey-bridge-test-" + std::to_string(::getpid()));
  Calibration calibration_ = mock_calibration();
  std::chrono::milliseconds off_after_{60'000};
  double rate_ = 1000;
  std::uint64_t robot_ = messaging::robot_number("bench");
  messaging::in_memory::Bus bus_;
  std::shared_ptr<messaging::Signal> signal_ = std::make_shared<messaging::Signal>();
  messaging::in_memory::Bus emergency_bus_;  // stands for the other vendor
  std::unique_ptr<messaging::Participant> participant_ = bus_.join("bridge");
  std::unique_ptr<messaging::Participant> emergency_participant_ = emergency_bus_.join("bridge");
  Asker anne_{bus_, robot_, 7};
  Asker bert_{bus_, robot_, 8};
  drivers::MockDriver* mock_ = nullptr;
  std::unique_ptr<StateFile> file_;
  std::unique_ptr<ControlLoop> control_;
  std::unique_ptr<Bridge> bridge_;
};

TEST_F(BridgeTest, AnInactiveRobotIsNotClaimed) {
  until([&] { return control_->status().state == RobotState::inactive; });
  const auto reply = ask(RobotRequestKind::claim);
  EXPECT_FALSE(reply.granted);
  EXPECT_EQ(reply.reason, "the robot is inactive");
  EXPECT_FALSE(mock_->is_enabled());
}

TEST_F(BridgeTest, TheClaimsCommandsMoveTheServosStepByStep) {
  const auto token = claim();
  for (std::uint32_t step = 0; step < 20; ++step) {
    const auto state = order(command(token, 1, step, 10 + step));
    ASSERT_EQ(state.outcome, StepOutcome::done) << state.reason;
    EXPECT_EQ(state.time_step, step);
    EXPECT_THAT(state.commanded, Each(10 + step));
    EXPECT_THAT(state.reported, Each(10 + step));
    EXPECT_EQ(state.feet_down, step == 0 ? 15U : 0U);
    EXPECT_TRUE(state.measured);
  }
  EXPECT_THAT(mock_->position(), Each(29));
}

TEST_F(BridgeTest, ActivationMovesNothing) {
  Pose somewhere{};
  somewhere.fill(23);
  mock_->put(somewhere);
  claim();
  EXPECT_EQ(mock_->position(), somewhere);
  EXPECT_EQ(mock_->moves(), 0U);
}

TEST_F(BridgeTest, NoneOfAnOldClaimsCommandsMovesAServo) {
  const auto old = claim();
  order(command(old, 1, 0, 11));
  EXPECT_TRUE(ask(RobotRequestKind::release, old).granted);
  const auto token = ask(RobotRequestKind::claim, 0, &bert_).token;
  EXPECT_GT(token, old);
  const auto moves = mock_->moves();
  for (std::uint32_t step = 1; step < 200; ++step) send(command(old, 1, step, 20), anne_);
  EXPECT_EQ(counter("commands_under_no_claim"), 199U);
  EXPECT_EQ(mock_->moves(), moves);
  EXPECT_THAT(mock_->position(), Each(11));
}

TEST_F(BridgeTest, AClaimIsOneHoldersOnly) {
  claim();
  const auto reply = ask(RobotRequestKind::claim, 0, &bert_);
  EXPECT_FALSE(reply.granted);
  EXPECT_THAT(reply.reason, HasSubstr("held by 0000000000000007"));
}

TEST_F(BridgeTest, TokensOutliveTheBridge) {
  const auto token = claim();
  end();
  start();
  EXPECT_GT(claim(), token);
}

TEST_F(BridgeTest, EmergencyStopLatchesOverARestartUntilItIsReset) {
  const auto token = claim();
  RobotRequest stop;
  stop.kind = RobotRequestKind::stop;
  stop.reason = "it smells";
  const auto stopped = ask(stop, &bert_);  // without any claim
  EXPECT_TRUE(stopped.granted);
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(stopped.reason, "") << "the device has confirmed";
  EXPECT_FALSE(mock_->is_enabled());
  send(command(token, 1, 0, 20), anne_);
  EXPECT_EQ(mock_->moves(), 0U);
  for (int life = 0; life < 2; ++life) {
    EXPECT_FALSE(ask(RobotRequestKind::activate).granted);
    EXPECT_EQ(ask(RobotRequestKind::claim).reason, "emergency stop: it smells");
    end();
    start();
    until([&] { return control_->status().state == RobotState::inactive; });
  }
  EXPECT_TRUE(ask(RobotRequestKind::reset).granted);
  EXPECT_FALSE(mock_->is_enabled()) << "resetting turns nothing on";
  EXPECT_GT(claim(), token);
}

TEST_F(BridgeTest, TheEmergencyDoorLetsTheStopInAndNothingElse) {
  Asker other(emergency_bus_, robot_, 9);
  claim();
  for (const auto kind : {RobotRequestKind::claim, RobotRequestKind::deactivate, RobotRequestKind::reset}) {
    RobotRequest request;
    request.kind = kind;
    other.asker.begin(request, Clock::now());
    for (int steps = 0; steps < 50; ++steps) step();
    EXPECT_FALSE(other.asker.poll(Clock::now()).has_value());
    EXPECT_TRUE(mock_->is_enabled());
  }
  const auto stopped = ask(RobotRequestKind::stop, 0, &other);
  EXPECT_TRUE(stopped.stopped);
  EXPECT_FALSE(mock_->is_enabled());
  EXPECT_EQ(ask(RobotRequestKind::claim).reason, "emergency stop: no reason given");
}

TEST_F(BridgeTest, AStopThatComesThroughBothDoorsIsAnsweredThroughBoth) {
  Asker other(emergency_bus_, robot_, 7);  // the same program over the other vendor
  claim();
  RobotRequest stop;
  stop.kind = RobotRequestKind::stop;
  std::vector<messaging::RobotAsker*> askers{&anne_.asker, &other.asker};
  for (auto* asker : askers) asker->begin(stop, Clock::now());
  until([&] {
    std::erase_if(askers, [](auto* asker) { return asker->poll(Clock::now()).has_value(); });
    return askers.empty();
  });
  EXPECT_TRUE(bridge_->stopped());
}

TEST_F(BridgeTest, WhatIsNoNumberMovesNothingAndVoidsTheEvaluation) {
  const auto token = claim();
  order(command(token, 1, 0, 10));
  const auto moves = mock_->moves();
  const auto state = order(command(token, 1, 1, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(state.outcome, StepOutcome::voided);
  EXPECT_THAT(state.reason, HasSubstr("no number"));
  EXPECT_EQ(mock_->moves(), moves);
  EXPECT_EQ(order(command(token, 2, 0, 10)).outcome, StepOutcome::done);
}

TEST_F(BridgeTest, PositionsOutOfRangeAreClampedAndCounted) {
  const auto token = claim();
  const auto state = order(command(token, 1, 0, 1e6));
  EXPECT_EQ(state.outcome, StepOutcome::done);
  EXPECT_THAT(state.commanded, Each(highest_position));
  EXPECT_EQ(counter("setpoints_clamped"), servos);
}

TEST_F(BridgeTest, ALateStepVoidsTheEvaluation) {
  const auto token = claim();
  order(command(token, 1, 0, 10));
  ServoState state;
  until([&] {
    const auto states = anne_.states->take();
    if (!states.empty()) state = states.back();
    return !states.empty();
  });
  EXPECT_EQ(state.outcome, StepOutcome::voided);
  EXPECT_THAT(state.reason, HasSubstr("has not come within 500 ms"));
  EXPECT_EQ(counter("evaluations_voided"), 1U);
}

TEST_F(BridgeTest, CommandsForAnotherRobotAreCountedAndIgnored) {
  const auto token = claim();
  auto other = command(token, 1, 0, 20);
  ++other.robot;
  send(other, anne_);
  EXPECT_EQ(counter("samples_for_other_robots"), 1U);
  EXPECT_EQ(mock_->moves(), 0U);
}

TEST_F(BridgeTest, ADeviceThatFailsVoidsTheEvaluationAndComesBackWhereItStands) {
  const auto token = claim();
  order(command(token, 1, 0, 17));
  mock_->inject({.error = DriverError::Kind::garbled, .calls = 2});
  const auto state = order(command(token, 1, 1, 18));
  EXPECT_EQ(state.outcome, StepOutcome::voided);
  until([&] {
    const auto status = control_->status();
    return status.device_errors >= 2 && status.state == RobotState::active;
  });
  EXPECT_THAT(mock_->position(), Each(17)) << "the step that was lost is not made later";
  EXPECT_TRUE(ask(RobotRequestKind::claim, token).granted) << "its holder has waited for it";
  EXPECT_EQ(order(command(token, 2, 0, 17)).outcome, StepOutcome::done);
  EXPECT_GT(counter("device_errors"), 0U);
}

TEST_F(BridgeTest, AStopDoesNotWaitForADeviceThatFails) {
  const auto token = claim();
  order(command(token, 1, 0, 17));
  mock_->inject({.error = DriverError::Kind::silent, .calls = -1});
  until([&] { return control_->status().state == RobotState::fault; });
  const auto stopped = ask(RobotRequestKind::stop);
  EXPECT_TRUE(stopped.granted);
  EXPECT_EQ(stopped.reason, "latched, but the device has not confirmed that its servos are off");
  until([&] { return !mock_->is_enabled(); });
  EXPECT_FALSE(control_->status().servos_off) << "it still has not confirmed";
  mock_->inject({.calls = 0});
  until([&] { return control_->status().servos_off; });
  EXPECT_EQ(control_->status().state, RobotState::inactive);
  EXPECT_FALSE(mock_->is_enabled());
}

TEST_F(BridgeTest, PlacingGoesThereUnderTheClaimOnly) {
  const auto token = claim();
  RobotRequest place;
  place.kind = RobotRequestKind::place;
  place.position.fill(25);
  place.token = token + 1;
  EXPECT_FALSE(ask(place).granted);
  EXPECT_THAT(mock_->position(), Each(10));
  place.token = token;
  EXPECT_TRUE(ask(place).granted);
  EXPECT_THAT(mock_->position(), Each(25));
}

TEST_F(BridgeTest, StatusTellsWhatIsGoingOn) {
  const auto reader = anne_.participant->reader<messaging::RobotStatus>(anne_.signal);
  const auto token = claim();
  messaging::RobotStatus status;
  until([&] {
    for (const auto& sample : reader->take()) status = sample;
    return status.token == token;
  });
  EXPECT_EQ(status.name, "bench");
  EXPECT_EQ(status.robot, robot_);
  EXPECT_EQ(status.state, RobotState::active);
  EXPECT_EQ(status.holder, 7U);
  EXPECT_EQ(status.rate, 1000);
  EXPECT_THAT(status.scheduling, HasSubstr("SCHED_"));
}

class IdleBridgeTest : public BridgeTest {
 protected:
  IdleBridgeTest() {
    end();
    off_after_ = 150ms;
    start();
  }
};

TEST_F(IdleBridgeTest, ServosThatNobodyNeedsAreTurnedOff) {
  claim();
  until([&] { return control_->status().state == RobotState::inactive; });
  EXPECT_FALSE(mock_->is_enabled());
  EXPECT_THAT(control_->status().reason, HasSubstr("nobody needed the servos for 150 ms"));
}

TEST_F(IdleBridgeTest, ServosOfADeviceThatFailsForTooLongAreTurnedOffAndStayOff) {
  claim();
  mock_->inject({.error = DriverError::Kind::garbled, .calls = -1});
  until([&] { return !mock_->is_enabled(); });
  mock_->inject({.calls = 0});
  until([&] { return control_->status().state == RobotState::inactive; });
  EXPECT_FALSE(mock_->is_enabled());
  EXPECT_EQ(control_->status().reason, "the device had failed for 150 ms");
}

class UnhurriedBridgeTest : public BridgeTest {
 protected:
  UnhurriedBridgeTest() {
    end();
    rate_ = 100;
    start();
  }
};

TEST_F(UnhurriedBridgeTest, AMoveThatIsHeldUpIsWaitedForAndCounted) {
  const auto token = claim();
  ASSERT_EQ(order(command(token, 1, 0, 11)).outcome, StepOutcome::done);
  mock_->delay_next_move(3);
  const auto state = order(command(token, 1, 1, 12));
  ASSERT_EQ(state.outcome, StepOutcome::done) << state.reason;
  EXPECT_THAT(state.reported, Each(12)) << "not where the servos were when they were first asked";
  EXPECT_EQ(counter("late_moves"), 1U);
}

TEST_F(UnhurriedBridgeTest, AMoveThatEndsBetweenTwoQuestionsIsReadAnew) {
  const auto token = claim();
  ASSERT_EQ(order(command(token, 1, 0, 11)).outcome, StepOutcome::done);
  mock_->delay_next_move(1);
  const auto state = order(command(token, 1, 1, 12));
  ASSERT_EQ(state.outcome, StepOutcome::done) << state.reason;
  EXPECT_THAT(state.reported, Each(12)) << "the first answer was of a move that had not ended";
  EXPECT_EQ(counter("late_moves"), 1U);
}

TEST_F(UnhurriedBridgeTest, AMoveThatNeverEndsVoidsTheEvaluation) {
  const auto token = claim();
  mock_->delay_next_move(std::numeric_limits<int>::max());
  const auto state = order(command(token, 1, 0, 11));
  EXPECT_EQ(state.outcome, StepOutcome::voided);
  EXPECT_THAT(state.reason, HasSubstr("still moving 1000 ms after the end of their move"));
}

class SlowBridgeTest : public BridgeTest {
 protected:
  SlowBridgeTest() {
    end();
    for (auto& joint : calibration_.joints) joint.slew_rate = 100;
    start();
  }
};

TEST_F(SlowBridgeTest, APlacingEndsWithItsClaim) {
  const auto token = claim();
  RobotRequest place;
  place.kind = RobotRequestKind::place;
  place.position.fill(0);
  place.token = token;
  anne_.asker.begin(place, Clock::now());
  until([&] { return mock_->position()[0] < 9; });
  EXPECT_TRUE(ask(RobotRequestKind::release, token).granted);
  const auto halted_at = mock_->position();
  EXPECT_GT(halted_at[0], 0) << "on its way";
  for (int steps = 0; steps < 50; ++steps) step();
  EXPECT_EQ(mock_->position(), halted_at);
  EXPECT_TRUE(mock_->is_enabled()) << "it holds";
}

}  // namespace
}  // namespace lamprey::robot_bridge
