#include "client/sweep_watch.hpp"

#include "client/failure.hpp"
#include "messaging/in_memory/bus.hpp"

#include <gtest/gtest.h>

namespace lamprey::client {
namespace {

using std::chrono::seconds;

class SweepWatchTest : public testing::Test {
 protected:
  static constexpr experiment::Id128 database{1, 2};
  static constexpr experiment::Id128 sweep{3, 4};
  messaging::in_memory::Bus bus;
  std::shared_ptr<messaging::Signal> signal = std::make_shared<messaging::Signal>();
  std::unique_ptr<messaging::Participant> client_participant = bus.join("client");
  std::unique_ptr<messaging::Participant> coordinator = bus.join("coordinator");
  std::unique_ptr<messaging::Reader<messaging::Request>> requests = coordinator->reader<messaging::Request>(signal);
  std::unique_ptr<messaging::Writer<messaging::SweepProgress>> progress =
      coordinator->writer<messaging::SweepProgress>();
  std::unique_ptr<messaging::Writer<messaging::Reply>> replies =
      coordinator->writer<messaging::Reply>(messaging::Partition::of(42));
  CoordinatorClient client{*client_participant, signal, 42};
  Clock::time_point now{std::chrono::hours{1}};
  SweepWatch watch{*client_participant, signal, client, database, sweep, now};

  void publish(const std::string& state, std::uint64_t done, experiment::Id128 of = database) {
    messaging::SweepProgress sample;
    sample.origin.database = of;
    sample.sweep = sweep;
    sample.state = state;
    sample.jobs = 10;
    sample.done = done;
    ASSERT_TRUE(progress->write(sample));
  }

  void answer(const idl::Reply& reply) {
    const auto request = requests->take().at(0);
    messaging::Reply sample;
    sample.origin.database = database;
    sample.client = request.client;
    sample.correlation = request.correlation;
    const auto bytes = reply.SerializeAsString();
    sample.payload.assign(bytes.begin(), bytes.end());
    ASSERT_TRUE(replies->write(sample));
  }
};

TEST_F(SweepWatchTest, FollowsPublishedProgressToTheEnd) {
  publish("running", 3);
  watch.step(now);
  ASSERT_TRUE(watch.latest());
  EXPECT_EQ(watch.latest()->done, 3U);
  EXPECT_FALSE(watch.ended());
  publish("finished", 10);
  watch.step(now);
  EXPECT_TRUE(watch.ended());
  EXPECT_TRUE(requests->take().empty()) << "nobody had to be asked";
}

TEST_F(SweepWatchTest, IgnoresASweepOfAnotherDatabase) {
  publish("finished", 10, {9, 9});
  watch.step(now);
  EXPECT_FALSE(watch.latest());
}

TEST_F(SweepWatchTest, AsksWhenTheLastWordIsLost) {
  publish("running", 9);
  watch.step(now);
  watch.step(now + seconds{1});
  EXPECT_TRUE(requests->take().empty());
  watch.step(now + seconds{2});
  idl::Reply reply;
  auto* status = reply.mutable_status()->add_sweeps();
  status->set_id(experiment::to_hex(sweep));
  status->set_state("finished");
  status->mutable_counts()->set_done(10);
  answer(reply);
  watch.step(now + seconds{2});
  EXPECT_TRUE(watch.ended());
  EXPECT_EQ(watch.latest()->done, 10U);
}

TEST_F(SweepWatchTest, ALateWordDoesNotUndoTheEnd) {
  publish("finished", 10);
  watch.step(now);
  publish("running", 4);
  watch.step(now);
  EXPECT_TRUE(watch.ended());
  EXPECT_EQ(watch.latest()->done, 10U);
}

TEST_F(SweepWatchTest, ASweepThatTheCoordinatorNoLongerKnowsIsAFailure) {
  watch.step(now + seconds{2});
  idl::Reply reply;
  reply.mutable_error()->set_code("unknown_sweep");
  reply.mutable_error()->add_messages("no sweep");
  answer(reply);
  EXPECT_THROW(watch.step(now + seconds{2}), Failure);
}

}  // namespace
}  // namespace lamprey::client
