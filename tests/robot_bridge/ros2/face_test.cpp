// The robot's face to ROS 2, with a real bridge and the mock robot behind it and a node that is none: what is written
// is kept, what is taken is what the test has put there.
#include "robot_bridge/ros2/face.hpp"

#include "messaging/in_memory/bus.hpp"
#include "messaging/participant_of.hpp"
#include "messaging/robot/robot_asker.hpp"
#include "messaging/robot/robot_name.hpp"
#include "robot_bridge/drivers/mock_driver.hpp"
#include "robot_bridge/ros2/angles.hpp"

#include <cmath>
#include <deque>
#include <filesystem>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <unistd.h>
#include <vector>

namespace lamprey::robot_bridge::ros2 {
namespace {

using namespace std::chrono_literals;
using messaging::RobotReply;
using messaging::RobotRequest;
using messaging::RobotRequestKind;
using ::testing::Each;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class FakeNode final
    : public messaging::Overrides<FakeNode, wire::Node, wire::JointState, wire::Diagnostics, wire::JointCommand> {
 public:
  template <class Message>
  std::deque<Message>& messages() {
    return std::get<std::deque<Message>>(messages_);
  }

  template <class Message>
  struct Writer final : messaging::Writer<Message> {
    explicit Writer(std::deque<Message>& all) : messages(all) {}
    messaging::WriteResult write(const Message& message) override {
      messages.push_back(message);
      return {};
    }
    std::deque<Message>& messages;
  };
  template <class Message>
  struct Reader final : messaging::Reader<Message> {
    explicit Reader(std::deque<Message>& all) : messages(all) {}
    std::vector<Message> take(std::size_t) override {
      std::vector<Message> taken(messages.begin(), messages.end());
      messages.clear();
      return taken;
    }
    std::deque<Message>& messages;
  };

  template <class Message>
  std::unique_ptr<messaging::Writer<Message>> open_writer(messaging::Partition) {
    return std::make_unique<Writer<Message>>(messages<Message>());
  }
  template <class Message>
  std::unique_ptr<messaging::Reader<Message>> open_reader(messaging::Partition, std::shared_ptr<messaging::Signal>) {
    return std::make_unique<Reader<Message>>(messages<Message>());
  }
  std::uint64_t malformed_samples() const override { return 0; }

 private:
  std::tuple<std::deque<wire::JointState>, std::deque<wire::Diagnostics>, std::deque<wire::JointCommand>> messages_;
};

/// Narrower than the robot's own range, so that limits can be seen to act, and slower than a time step.
Calibration narrow_calibration() {
  Calibration calibration = mock_calibration();
  for (auto& joint : calibration.joints) {
    joint.minimum = joint.to_device(5);
    joint.maximum = joint.to_device(20);
    joint.slew_rate = 500 * joint.per_unit;
  }
  return calibration;
}

class FaceTest : public ::testing::Test {
 protected:
  FaceTest() {
    std::filesystem::remove_all(folder_);
    auto driver = std::make_unique<drivers::MockDriver>(calibration_);
    mock_ = driver.get();
    file_ = std::make_unique<StateFile>(folder_, "bench");
    control_ =
        std::make_unique<ControlLoop>(std::move(driver), calibration_,
                                      ControlOptions{.rate = 1000, .off_after = 60s, .retry_interval = 10ms}, signal_);
    BridgeOptions options;
    options.robot = "bench";
    options.driver = "mock";
    options.rate = 1000;
    bridge_ = std::make_unique<Bridge>(*participant_, signal_, *control_, *file_, options, Clock::now());
    face_ = std::make_unique<Face>(node_, signal_, *bridge_, *control_, calibration_, "bench");
  }
  ~FaceTest() override {
    face_.reset();
    bridge_.reset();
    control_.reset();
    file_.reset();
    std::filesystem::remove_all(folder_);
  }

  void step() {
    signal_->wait_for(1ms);
    bridge_->step(Clock::now());
    face_->step(Clock::now(), std::chrono::system_clock::now());
  }
  void until(const std::function<bool()>& condition) {
    const auto deadline = Clock::now() + 20s;
    while (!condition()) {
      ASSERT_LT(Clock::now(), deadline);
      step();
    }
  }

  RobotReply ask(RobotRequestKind kind) {
    RobotRequest request;
    request.kind = kind;
    request.reason = kind == RobotRequestKind::stop ? "a test" : "";
    asker_.begin(request, Clock::now());
    RobotReply reply;
    until([&] {
      const auto answer = asker_.poll(Clock::now());
      if (answer) reply = *answer;
      return answer.has_value();
    });
    return reply;
  }
  void activate() {
    until([&] { return control_->status().state == RobotState::inactive; });
    ASSERT_TRUE(ask(RobotRequestKind::activate).granted);
  }

  /// The angles at which all joints are at that position.
  std::vector<double> angles(double position) const {
    Pose pose{};
    pose.fill(position);
    return to_radians(calibration_, pose);
  }
  void command(std::vector<double> positions, std::uint32_t offset = 0) {
    node_.messages<wire::JointCommand>().push_back({.offset = offset, .positions = std::move(positions)});
  }
  void refused(const std::string& why) {
    const auto moves = mock_->moves();
    until([&] { return counter("ros2_commands_refused_" + why) > 0; });
    EXPECT_EQ(counter("ros2_commands_obeyed"), 0U);
    EXPECT_EQ(mock_->moves(), moves);
  }
  std::uint64_t counter(const std::string& name) const {
    for (const auto& one : face_->counters()) {
      if (one.name == name) return one.value;
    }
    ADD_FAILURE() << "no counter " << name;
    return 0;
  }
  const wire::JointState& joints() { return node_.messages<wire::JointState>().back(); }
  const wire::DiagnosticStatus& diagnostics() { return node_.messages<wire::Diagnostics>().back().statuses.at(0); }
  std::string value(const std::string& key) {
    for (const auto& [name, text] : diagnostics().values) {
      if (name == key) return text;
    }
    return "(no " + key + ")";
  }
  bool at(double position) {
    const auto wanted = angles(position);
    if (node_.messages<wire::JointState>().empty()) return false;
    for (std::size_t servo = 0; servo < servos; ++servo) {
      if (std::abs(joints().positions.at(servo) - wanted[servo]) > 1e-9) return false;
    }
    return true;
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("lamprey-face-" + std::to_string(::getpid()));
  const Calibration calibration_ = narrow_calibration();
  messaging::in_memory::Bus bus_;
  std::unique_ptr<messaging::Participant> participant_ = bus_.join("bridge");
  std::unique_ptr<messaging::Participant> other_ = bus_.join("asker");
  std::shared_ptr<messaging::Signal> signal_ = std::make_shared<messaging::Signal>();
  messaging::RobotAsker asker_{*other_, signal_, messaging::robot_number("bench"), 77};
  FakeNode node_;
  drivers::MockDriver* mock_ = nullptr;
  std::unique_ptr<StateFile> file_;
  std::unique_ptr<ControlLoop> control_;
  std::unique_ptr<Bridge> bridge_;
  std::unique_ptr<Face> face_;
};

TEST_F(FaceTest, TellsWhereTheJointsAreWhileNothingMovesThem) {
  const auto before = std::chrono::system_clock::now() - 1s;
  until([&] { return node_.messages<wire::JointState>().size() > 1; });
  EXPECT_THAT(joints().names, ElementsAreArray(joint_names));
  EXPECT_EQ(joints().frame, "base_link");
  EXPECT_TRUE(at(10));
  EXPECT_THAT(joints().efforts, IsEmpty());
  const auto stamp = std::chrono::system_clock::time_point(std::chrono::seconds(joints().stamp.seconds)) +
                     std::chrono::nanoseconds(joints().stamp.nanoseconds);
  EXPECT_GE(stamp, before);
  EXPECT_LE(stamp, std::chrono::system_clock::now());
}

TEST_F(FaceTest, OfEachReadingTellsOnce) {
  until([&] { return !node_.messages<wire::JointState>().empty(); });
  until([&] { return node_.messages<wire::JointState>().size() > 3; });
  const auto& all = node_.messages<wire::JointState>();
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_NE(all[i - 1].stamp, all[i].stamp);
}

TEST_F(FaceTest, TellsNoPositionsWhileTheDeviceIsAway) {
  until([&] { return !node_.messages<wire::JointState>().empty(); });
  mock_->inject({.error = DriverError::Kind::disconnected, .calls = -1});
  until([&] { return control_->status().state == RobotState::unconfigured; });
  step();
  const auto told = node_.messages<wire::JointState>().size();
  for (int i = 0; i < 20; ++i) step();
  EXPECT_EQ(node_.messages<wire::JointState>().size(), told);
  EXPECT_EQ(diagnostics().level, wire::DiagnosticLevel::warn);
  EXPECT_THAT(diagnostics().message, HasSubstr("unconfigured: the mock is gone"));
}

TEST_F(FaceTest, ACommandMovesAnUnclaimedActiveRobotAtItsSlewRate) {
  activate();
  const auto moves = mock_->moves();
  command(angles(16));
  until([&] { return at(16); });
  // 6 units at 500 units per second and 1000 steps per second.
  EXPECT_GE(mock_->moves(), moves + 12);
  EXPECT_EQ(counter("ros2_commands_obeyed"), 1U);
  EXPECT_EQ(counter("ros2_commands_out_of_range"), 0U);
}

TEST_F(FaceTest, AMovingRobotIsSeenToMove) {
  activate();
  node_.messages<wire::JointState>().clear();
  command(angles(18));
  until([&] { return at(18); });
  bool between = false;
  bool velocity = false;
  for (const auto& state : node_.messages<wire::JointState>()) {
    between = between || (state.positions[0] > angles(10.5)[0] && state.positions[0] < angles(17.5)[0]);
    velocity = velocity || (state.velocities.size() == servos && state.velocities[0] > 0);
  }
  EXPECT_TRUE(between);
  EXPECT_TRUE(velocity);
}

TEST_F(FaceTest, ACommandBeyondTheRangeEndsAtTheRange) {
  activate();
  command(angles(1000));
  until([&] { return at(20); });
  command(std::vector<double>(servos, std::numeric_limits<double>::lowest()));
  until([&] { return at(5); });
  EXPECT_EQ(counter("ros2_commands_out_of_range"), 2U);
}

TEST_F(FaceTest, OfSeveralCommandsTheNewestIsObeyed) {
  activate();
  command(angles(15));
  command(angles(7));
  until([&] { return at(7); });
  EXPECT_EQ(counter("ros2_commands_obeyed"), 1U);
  EXPECT_EQ(counter("ros2_commands_superseded"), 1U);
}

TEST_F(FaceTest, WhileAClaimIsInForceNoCommandMovesAServo) {
  activate();
  const auto claim = ask(RobotRequestKind::claim);
  ASSERT_TRUE(claim.granted);
  command(angles(15));
  refused("claimed");
  EXPECT_EQ(value("claimed"), "yes");
}

TEST_F(FaceTest, AnInactiveRobotIsNotMoved) {
  until([&] { return control_->status().state == RobotState::inactive; });
  command(angles(15));
  refused("not_active");
}

TEST_F(FaceTest, AStoppedRobotIsNotMoved) {
  activate();
  ASSERT_TRUE(ask(RobotRequestKind::stop).granted);
  command(angles(15));
  refused("not_active");
  EXPECT_EQ(diagnostics().level, wire::DiagnosticLevel::warn);
  EXPECT_EQ(value("stopped"), "yes");
  EXPECT_THAT(diagnostics().message, HasSubstr("emergency stop: a test"));
}

TEST_F(FaceTest, CommandsOfAnotherSizeAreRefused) {
  activate();
  command({});
  command(std::vector<double>(servos - 1, 0.1));
  command(std::vector<double>(servos + 1, 0.1));
  command(std::vector<double>(servos, 0.1), 1);
  refused("wrong_size");
  EXPECT_EQ(counter("ros2_commands_refused_wrong_size"), 4U);
}

TEST_F(FaceTest, CommandsThatAreNoNumbersAreRefused) {
  activate();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    auto positions = angles(15);
    positions[5] = bad;
    command(positions);
  }
  refused("not_numbers");
  EXPECT_EQ(counter("ros2_commands_refused_not_numbers"), 3U);
}

TEST_F(FaceTest, AStreamOfCommandsDoesNotKeepTheServosOn) {
  activate();
  RobotRequest request;
  request.kind = RobotRequestKind::deactivate;
  asker_.begin(request, Clock::now());
  until([&] {
    command(angles(15));
    return control_->status().servos_off;
  });
  EXPECT_EQ(control_->status().state, RobotState::inactive);
}

TEST_F(FaceTest, AnOrderToTurnTheServosOffIsNotReplaced) {
  activate();
  control_->deactivate();
  EXPECT_FALSE(control_->place_if_free(standing_pose()));
  until([&] { return control_->status().servos_off; });
}

TEST_F(FaceTest, DiagnosticsTellEachChangeAtOnce) {
  activate();
  EXPECT_EQ(diagnostics().level, wire::DiagnosticLevel::ok);
  EXPECT_EQ(diagnostics().name, "lamprey-bridge: bench");
  EXPECT_EQ(diagnostics().hardware, "the simulator's quadruped");
  EXPECT_EQ(value("state"), "active");
  EXPECT_EQ(value("claimed"), "no");
  EXPECT_EQ(value("steps"), "0");
  EXPECT_EQ(value("ros2_commands_obeyed"), "0");
}

TEST_F(FaceTest, AFaultIsAnError) {
  activate();
  mock_->inject({.error = DriverError::Kind::garbled, .calls = -1});
  until([&] { return diagnostics().level == wire::DiagnosticLevel::error; });
  EXPECT_EQ(value("state"), "fault");
}

TEST_F(FaceTest, DiagnosticsComeOnceASecondWhileNothingChanges) {
  until([&] { return control_->status().state == RobotState::inactive; });
  step();
  auto now = Clock::now();
  const auto told = [&] { return node_.messages<wire::Diagnostics>().size(); };
  face_->step(now, {});
  const auto before = told();
  face_->step(now + 400ms, {});
  EXPECT_LE(told(), before);
  face_->step(now + 1100ms, {});
  EXPECT_EQ(told(), before + 1);
  face_->step(now + 1200ms, {});
  EXPECT_EQ(told(), before + 1);
}

TEST_F(FaceTest, TellsThatItEnds) {
  activate();
  face_->finish(std::chrono::system_clock::now());
  EXPECT_EQ(value("state"), "finalized");
  EXPECT_EQ(diagnostics().level, wire::DiagnosticLevel::warn);
}

}  // namespace
}  // namespace lamprey::robot_bridge::ros2
