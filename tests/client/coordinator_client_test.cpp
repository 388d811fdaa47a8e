#include "client/coordinator_client.hpp"

#include "messaging/in_memory/bus.hpp"

#include <gtest/gtest.h>

namespace lamprey::client {
namespace {

using messaging::in_memory::Bus;
using messaging::in_memory::Envelope;
using messaging::in_memory::Fate;
using std::chrono::milliseconds;
using std::chrono::seconds;

/// A coordinator's side of the conversation, answered by hand.
class CoordinatorClientTest : public testing::Test {
 protected:
  Bus bus;
  std::shared_ptr<messaging::Signal> signal = std::make_shared<messaging::Signal>();
  std::unique_ptr<messaging::Participant> client_participant = bus.join("client");
  std::unique_ptr<messaging::Participant> coordinator = bus.join("coordinator");
  std::unique_ptr<messaging::Reader<messaging::Request>> requests = coordinator->reader<messaging::Request>(signal);
  std::unique_ptr<messaging::Writer<messaging::Reply>> replies =
      coordinator->writer<messaging::Reply>(messaging::Partition::of(42));
  CoordinatorClient client{*client_participant, signal, 42};
  Clock::time_point now{std::chrono::hours{1}};

  static idl::Request status_request() {
    idl::Request request;
    request.mutable_status();
    return request;
  }

  static messaging::Reply reply_to(const messaging::Request& request, const std::string& database) {
    idl::Reply reply;
    reply.mutable_status()->set_database(database);
    const auto bytes = reply.SerializeAsString();
    messaging::Reply sample;
    sample.client = request.client;
    sample.correlation = request.correlation;
    sample.origin.epoch = 3;
    sample.payload.assign(bytes.begin(), bytes.end());
    return sample;
  }

  void answer(const messaging::Reply& reply) { ASSERT_TRUE(replies->write(reply)); }
};

TEST_F(CoordinatorClientTest, GetsTheReplyToItsRequest) {
  client.begin(status_request(), now);
  const auto received = requests->take();
  ASSERT_EQ(received.size(), 1U);
  EXPECT_EQ(received[0].client, 42U);
  EXPECT_EQ(received[0].origin.science_version, experiment::science_version);
  EXPECT_FALSE(client.poll(now));
  answer(reply_to(received[0], "a.db"));
  const auto reply = client.poll(now);
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status().database(), "a.db");
  EXPECT_EQ(client.answered_by().epoch, 3U);
  EXPECT_FALSE(client.waiting());
}

TEST_F(CoordinatorClientTest, ALostRequestIsSentAgainUnderTheSameCorrelation) {
  bus.on_sample([](const Envelope& envelope) {
    return envelope.get<messaging::Request>() != nullptr && envelope.ordinal == 0 ? Fate::drop : Fate::deliver;
  });
  client.begin(status_request(), now);
  EXPECT_TRUE(requests->take().empty());
  client.poll(now + milliseconds{900});
  EXPECT_TRUE(requests->take().empty()) << "it is not due yet";
  client.poll(now + seconds{1});
  client.poll(now + seconds{2});
  const auto received = requests->take();
  ASSERT_EQ(received.size(), 2U);
  EXPECT_EQ(received[0], received[1]);
}

TEST_F(CoordinatorClientTest, ALostReplyComesWithTheNextRequest) {
  bus.on_sample([](const Envelope& envelope) {
    return envelope.get<messaging::Reply>() != nullptr && envelope.ordinal == 0 ? Fate::drop : Fate::deliver;
  });
  client.begin(status_request(), now);
  answer(reply_to(requests->take().at(0), "lost.db"));
  EXPECT_FALSE(client.poll(now + seconds{1}));
  answer(reply_to(requests->take().at(0), "b.db"));
  const auto reply = client.poll(now + seconds{1});
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status().database(), "b.db");
}

TEST_F(CoordinatorClientTest, ALateReplyToAnEarlierRequestIsNotTakenForTheNewOne) {
  client.begin(status_request(), now);
  const auto first = requests->take().at(0);
  client.begin(status_request(), now);
  const auto second = requests->take().at(0);
  EXPECT_NE(first.correlation, second.correlation);
  answer(reply_to(first, "old.db"));
  EXPECT_FALSE(client.poll(now));
  answer(reply_to(second, "new.db"));
  EXPECT_EQ(client.poll(now).value_or(idl::Reply()).status().database(), "new.db");
}

TEST_F(CoordinatorClientTest, ADuplicatedReplyCountsOnce) {
  bus.on_sample([](const Envelope& envelope) {
    return envelope.get<messaging::Reply>() != nullptr ? Fate::duplicate : Fate::deliver;
  });
  client.begin(status_request(), now);
  answer(reply_to(requests->take().at(0), "a.db"));
  EXPECT_TRUE(client.poll(now));
  client.begin(status_request(), now);
  EXPECT_FALSE(client.poll(now));
}

TEST_F(CoordinatorClientTest, UnreadableRepliesAreSkipped) {
  client.begin(status_request(), now);
  auto reply = reply_to(requests->take().at(0), "a.db");
  const auto good = reply.payload;
  reply.payload = {0xff, 0xff, 0xff};
  answer(reply);
  EXPECT_FALSE(client.poll(now));
  EXPECT_TRUE(client.waiting());
  reply.payload = good;
  answer(reply);
  EXPECT_TRUE(client.poll(now));
}

TEST_F(CoordinatorClientTest, ACoordinatorThatStartsLaterGetsTheRequest) {
  requests.reset();
  client.begin(status_request(), now);
  requests = coordinator->reader<messaging::Request>(signal);
  EXPECT_EQ(requests->take().size(), 1U);
}

TEST_F(CoordinatorClientTest, AskingGivesUpAfterTheTimeoutOrWhenStopped) {
  EXPECT_FALSE(client.ask(status_request(), milliseconds{20}, [] { return false; }));
  EXPECT_FALSE(client.waiting());
  EXPECT_FALSE(client.ask(status_request(), std::chrono::hours{1}, [] { return true; }));
}

TEST(RandomId, IsNeverZeroAndDoesNotRepeat) {
  const auto first = random_id();
  EXPECT_NE(first, 0U);
  EXPECT_NE(first, random_id());
}

}  // namespace
}  // namespace lamprey::client
