// What one vendor's node publishes, another's takes: messages of ROS 2, over each vendor and each pair of them.
#include "messaging/ros2/node.hpp"

#include <chrono>
#include <cstdint>
#include <gtest/gtest.h>
#include <memory>
#include <ostream>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace lamprey::messaging::ros2 {
namespace {

/// Generous, because the machine may be busy with other tests; nothing here asserts how long something takes.
constexpr std::chrono::seconds patience{90};

struct Pair {
  std::string name;
  std::string writer;
  std::string reader;
};
void PrintTo(const Pair& pair, std::ostream* out) {
  *out << pair.writer << " to " << pair.reader;
}

/// ROS 2 has no isolation: each test takes a domain that other tests hardly have at the time.
std::uint32_t any_domain() {
  std::random_device random;
  return std::uniform_int_distribution<std::uint32_t>(110, 200)(random);
}

class NodeTest : public ::testing::TestWithParam<Pair> {
 protected:
  std::unique_ptr<Node> node(const std::string& vendor) const {
    return join({.vendor = vendor,
                 .domain = domain_,
                 .isolation = "test",
                 .peers = {},
                 .loopback_only = true,
                 .introduction = {}});
  }

  /// Writes the message again and again until the other side has got it.
  template <class Message>
  void goes_round(const Message& message) {
    const auto writing = node(GetParam().writer);
    const auto reading = node(GetParam().reader);
    const auto signal = std::make_shared<Signal>();
    const auto writer = writing->writer<Message>();
    const auto reader = reading->reader<Message>(signal);
    const auto deadline = std::chrono::steady_clock::now() + patience;
    std::vector<Message> taken;
    while (taken.empty()) {
      ASSERT_LT(std::chrono::steady_clock::now(), deadline) << "nothing has arrived";
      const auto written = writer->write(message);
      ASSERT_TRUE(written) << written.error;
      signal->wait_for(std::chrono::milliseconds(20));
      taken = reader->take();
    }
    EXPECT_EQ(taken.front(), message);
    EXPECT_EQ(reading->malformed_samples(), 0U);
  }

  std::uint32_t domain_ = any_domain();
};

JointState joint_state() {
  return {.stamp = {.seconds = 1'234'567, .nanoseconds = 999'999'999},
          .frame = "base_link",
          .names = {"front_left_vertical", "b"},
          .positions = {-0.5, 1e-300},
          .velocities = {0.25, -3},
          .efforts = {}};
}

TEST_P(NodeTest, JointStatesArriveAsTheyWere) {
  goes_round(joint_state());
}

TEST_P(NodeTest, EmptyJointStatesArrive) {
  goes_round(JointState{});
}

TEST_P(NodeTest, DiagnosticsArriveAsTheyWere) {
  goes_round(Diagnostics{.stamp = {.seconds = -1, .nanoseconds = 1},
                         .frame = "f",
                         .statuses = {{.level = DiagnosticLevel::error,
                                       .name = "lamprey-bridge: bench",
                                       .message = "fault: no answer",
                                       .hardware = "SSC-32",
                                       .values = {{"state", "fault"}, {"", "µ"}}},
                                      {}}});
}

TEST_P(NodeTest, JointCommandsArriveAsTheyWere) {
  goes_round(JointCommand{.offset = 2, .positions = {0, 0, 0.1, -0.2, 0.3, -0.4, 0.5, -0.6, 0.7, -0.8}});
}

TEST_P(NodeTest, AReaderThatComesLateIsToldWhereTheJointsAre) {
  const auto writing = node(GetParam().writer);
  const auto writer = writing->writer<JointState>();
  ASSERT_TRUE(writer->write(joint_state()));
  const auto reading = node(GetParam().reader);
  const auto signal = std::make_shared<Signal>();
  const auto reader = reading->reader<JointState>(signal);
  const auto deadline = std::chrono::steady_clock::now() + patience;
  std::vector<JointState> taken;
  while (taken.empty()) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline) << "nothing has arrived";
    signal->wait_for(std::chrono::milliseconds(50));
    taken = reader->take();
  }
  EXPECT_EQ(taken.front(), joint_state());
}

TEST_P(NodeTest, MessagesBeyondAllBoundsAreNotWritten) {
  const auto writing = node(GetParam().writer);
  const auto writer = writing->writer<JointState>();
  JointState message;
  message.frame.assign(100'000, 'x');
  const auto result = writer->write(message);
  EXPECT_EQ(result.kind, WriteResult::Kind::failed);
  EXPECT_EQ(result.error, "cannot write to rt/joint_states: frame_id: size 100000, at most 65536");
}

INSTANTIATE_TEST_SUITE_P(Pairs, NodeTest,
                         ::testing::Values(Pair{"Cyclone", "cyclonedds", "cyclonedds"},
                                           Pair{"Fast", "fastdds", "fastdds"},
                                           Pair{"FastToCyclone", "fastdds", "cyclonedds"},
                                           Pair{"CycloneToFast", "cyclonedds", "fastdds"}),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Node, AnUnknownVendorIsNamed) {
  try {
    join(
        {.vendor = "nobody", .domain = 1, .isolation = "test", .peers = {}, .loopback_only = true, .introduction = {}});
    FAIL() << "joined";
  } catch (const JoinError& error) {
    EXPECT_NE(std::string(error.what()).find("'nobody': no such vendor"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lamprey::messaging::ros2
