#include "messaging/keys.hpp"
#include "tests/conformance/world.hpp"
#include "tests/messaging/example_samples.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::messaging::conformance {
namespace {

class RoundTrip : public World {
 protected:
  /// Each sample arrives with every field as it was.
  template <class Sample>
  void expect_round_trips() {
    auto from = join_writer();
    auto to = join_reader();
    auto writer = from->template writer<Sample>();
    Inbox<Sample> inbox(*to);
    for (const Sample& sample : {Sample{}, testing::example<Sample>(), testing::extreme<Sample>()}) {
      const auto arrived = [&](const std::vector<Sample>& samples) {
        return !samples.empty() && samples.back() == sample;
      };
      // Repeated, since what is volatile may be lost before both know each other.
      for (int repetition = 0; repetition < 200 && !arrived(inbox.samples); ++repetition) {
        write(*writer, sample);
        for (int i = 0; i < 20 && !arrived(inbox.samples); ++i) {
          std::this_thread::sleep_for(std::chrono::milliseconds(5));
          inbox.take();
        }
      }
      ASSERT_FALSE(inbox.samples.empty());
      EXPECT_TRUE(inbox.samples.back() == sample);
    }
  }
};

TEST_P(RoundTrip, WorkerStatus) {
  expect_round_trips<WorkerStatus>();
}
TEST_P(RoundTrip, SweepSpecification) {
  expect_round_trips<SweepSpecification>();
}
TEST_P(RoundTrip, Lease) {
  expect_round_trips<Lease>();
}
TEST_P(RoundTrip, ResultBatchOfSixtyKilobytes) {
  expect_round_trips<ResultBatch>();
}
TEST_P(RoundTrip, ResultAcknowledgement) {
  expect_round_trips<ResultAcknowledgement>();
}
TEST_P(RoundTrip, Checkpoint) {
  expect_round_trips<Checkpoint>();
}
TEST_P(RoundTrip, Request) {
  expect_round_trips<Request>();
}
TEST_P(RoundTrip, Reply) {
  expect_round_trips<Reply>();
}
TEST_P(RoundTrip, SweepProgress) {
  expect_round_trips<SweepProgress>();
}
TEST_P(RoundTrip, Traffic) {
  expect_round_trips<Traffic>();
}
TEST_P(RoundTrip, RobotStatus) {
  expect_round_trips<RobotStatus>();
}
TEST_P(RoundTrip, RobotRequest) {
  expect_round_trips<RobotRequest>();
}
TEST_P(RoundTrip, RobotReply) {
  expect_round_trips<RobotReply>();
}
TEST_P(RoundTrip, ServoCommand) {
  expect_round_trips<ServoCommand>();
}
TEST_P(RoundTrip, ServoState) {
  expect_round_trips<ServoState>();
}

TEST_P(RoundTrip, EveryEnumerator) {
  auto from = join_writer();
  auto to = join_reader();
  auto writer = from->writer<Lease>();
  Inbox<Lease> inbox(*to);
  const auto kinds = {LeaseKind::welcome, LeaseKind::grant, LeaseKind::revoke, LeaseKind::refuse};
  for (const auto kind : kinds) {
    Lease lease;
    lease.kind = kind;
    write(*writer, lease);
  }
  ASSERT_TRUE(inbox.take_until_size(kinds.size()));
  std::vector<LeaseKind> received;
  for (const auto& lease : inbox.samples) received.push_back(lease.kind);
  EXPECT_THAT(received, ::testing::ElementsAreArray(kinds));
}

TEST_P(RoundTrip, SampleBeyondItsBoundIsRefusedByTheWriter) {
  auto from = join_writer();
  auto writer = from->writer<Lease>();
  Lease lease;
  lease.reason.assign(70'000, 'x');
  const WriteResult result = writer->write(lease);
  EXPECT_EQ(result.kind, WriteResult::Kind::failed);
  EXPECT_THAT(result.error, ::testing::HasSubstr("reason"));
}

INSTANTIATE_TEST_SUITE_P(Port, RoundTrip, ::testing::ValuesIn(all_pairs()), pair_name);

}  // namespace
}  // namespace lamprey::messaging::conformance
