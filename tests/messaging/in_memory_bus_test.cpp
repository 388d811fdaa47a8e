#include "messaging/in_memory/bus.hpp"
#include "messaging/qos.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace lamprey::messaging::in_memory {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class InMemoryBus : public ::testing::Test {
 protected:
  Bus bus;
  std::shared_ptr<Signal> signal = std::make_shared<Signal>();
  std::unique_ptr<Participant> coordinator = bus.join("coordinator");
  std::unique_ptr<Participant> worker = bus.join("worker");
};

Lease lease(std::uint64_t number) {
  Lease sample;
  sample.lease = number;
  return sample;
}

WorkerStatus status(std::uint64_t number, std::uint64_t heartbeat) {
  WorkerStatus sample;
  sample.origin.worker = number;
  sample.heartbeat = heartbeat;
  return sample;
}

std::vector<std::uint64_t> leases(Reader<Lease>& reader) {
  std::vector<std::uint64_t> numbers;
  for (const auto& sample : reader.take()) numbers.push_back(sample.lease);
  return numbers;
}

void write_leases(Writer<Lease>& writer, std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t number = first; number <= last; ++number) ASSERT_TRUE(writer.write(lease(number)));
}

TEST_F(InMemoryBus, ArrivesBeforeWriteReturnsAndNotifies) {
  auto writer = coordinator->writer<Lease>(Partition::of(1));
  auto reader = worker->reader<Lease>(signal, Partition::of(1));
  EXPECT_FALSE(signal->wait_for(milliseconds(0)));
  write_leases(*writer, 1, 2);
  EXPECT_TRUE(signal->wait_for(milliseconds(0)));
  EXPECT_THAT(leases(*reader), ElementsAre(1, 2));
}

TEST_F(InMemoryBus, TakeOfAPartLeavesTheRestAndNotifiesOfIt) {
  auto writer = coordinator->writer<Lease>();
  auto reader = worker->reader<Lease>(signal);
  write_leases(*writer, 1, 3);
  EXPECT_TRUE(signal->wait_for(milliseconds(0)));
  EXPECT_EQ(reader->take(2).size(), 2u);
  EXPECT_TRUE(signal->wait_for(milliseconds(0)));
  EXPECT_THAT(leases(*reader), ElementsAre(3));
}

TEST_F(InMemoryBus, FateSeesTopicOrdinalSenderPartitionAndSample) {
  std::vector<std::string> seen;
  bus.on_sample([&](const Envelope& envelope) {
    const auto* sample = envelope.get<Lease>();
    seen.push_back(std::string(envelope.topic) + " " + std::to_string(envelope.ordinal) + " " +
                   std::string(envelope.sender) + " " + std::to_string(envelope.partition.receiver) + " " +
                   (sample == nullptr ? "other" : std::to_string(sample->lease)));
    return Fate::deliver;
  });
  auto writer = coordinator->writer<Lease>(Partition::of(5));
  auto status_writer = worker->writer<WorkerStatus>();
  write_leases(*writer, 41, 42);
  ASSERT_TRUE(status_writer->write(status(1, 1)));
  EXPECT_THAT(seen, ElementsAre("lamprey/4/lease 0 coordinator 5 41", "lamprey/4/lease 1 coordinator 5 42",
                                "lamprey/4/worker_status 0 worker 0 other"));
}

TEST_F(InMemoryBus, DroppedSampleReachesNeitherPresentNorLateReaders) {
  auto writer = coordinator->writer<Lease>();
  auto reader = worker->reader<Lease>(signal);
  bus.on_sample([](const Envelope& envelope) { return envelope.ordinal == 1 ? Fate::drop : Fate::deliver; });
  write_leases(*writer, 1, 3);
  EXPECT_THAT(leases(*reader), ElementsAre(1, 3));
  auto late = worker->reader<Lease>(signal);
  EXPECT_THAT(leases(*late), ElementsAre(1, 3));
}

TEST_F(InMemoryBus, DuplicatedSampleArrivesTwice) {
  auto writer = coordinator->writer<Lease>();
  auto reader = worker->reader<Lease>(signal);
  bus.on_sample([](const Envelope&) { return Fate::duplicate; });
  write_leases(*writer, 1, 1);
  EXPECT_THAT(leases(*reader), ElementsAre(1, 1));
}

TEST_F(InMemoryBus, HeldSamplesComeInTheOrderOfTheirRelease) {
  auto writer = coordinator->writer<Lease>();
  auto reader = worker->reader<Lease>(signal);
  bus.on_sample([](const Envelope& envelope) { return envelope.ordinal < 3 ? Fate::hold : Fate::deliver; });
  write_leases(*writer, 1, 4);
  EXPECT_THAT(leases(*reader), ElementsAre(4));
  const std::string topic(Topic<Lease>::name);
  EXPECT_THAT(bus.held(), ElementsAre(Held{topic, 0}, Held{topic, 1}, Held{topic, 2}));
  EXPECT_TRUE(bus.release({topic, 2}));
  EXPECT_FALSE(bus.release({topic, 2}));
  bus.release_all();
  EXPECT_THAT(leases(*reader), ElementsAre(3, 1, 2));
  EXPECT_THAT(bus.held(), IsEmpty());
}

TEST_F(InMemoryBus, FateMayActOnTheBus) {
  auto writer = coordinator->writer<Lease>();
  auto reader = worker->reader<Lease>(signal);
  bus.on_sample([this](const Envelope& envelope) {
    if (envelope.ordinal == 1) bus.kill("coordinator");
    return Fate::deliver;
  });
  write_leases(*writer, 1, 3);
  EXPECT_THAT(leases(*reader), ElementsAre(1));
}

TEST_F(InMemoryBus, DisconnectionLosesSamplesInBothDirections) {
  auto lease_writer = coordinator->writer<Lease>();
  auto lease_reader = worker->reader<Lease>(signal);
  auto result_writer = worker->writer<ResultBatch>();
  auto result_reader = coordinator->reader<ResultBatch>(signal);
  bus.disconnect("worker");
  write_leases(*lease_writer, 1, 1);
  ASSERT_TRUE(result_writer->write({}));
  EXPECT_THAT(lease_reader->take(), IsEmpty());
  EXPECT_THAT(result_reader->take(), IsEmpty());
  bus.reconnect("worker");
  EXPECT_THAT(leases(*lease_reader), ElementsAre(1)) << "remembered by the transient-local writer";
  EXPECT_THAT(result_reader->take(), IsEmpty()) << "volatile";
  ASSERT_TRUE(result_writer->write({}));
  EXPECT_EQ(result_reader->take().size(), 1u);
}

TEST_F(InMemoryBus, ReconnectionReplaysOnlyBetweenThoseThatWereApart) {
  auto writer = coordinator->writer<Lease>();
  auto reader = worker->reader<Lease>(signal);
  auto bystander = bus.join("bystander");
  auto bystanders_reader = bystander->reader<Lease>(signal);
  write_leases(*writer, 1, 1);
  EXPECT_THAT(leases(*reader), ElementsAre(1));
  EXPECT_THAT(leases(*bystanders_reader), ElementsAre(1));
  bus.disconnect("worker");
  bus.reconnect("worker");
  EXPECT_THAT(leases(*reader), ElementsAre(1));
  EXPECT_THAT(leases(*bystanders_reader), IsEmpty());
}

TEST_F(InMemoryBus, KilledParticipantVanishesWithWhatItRemembered) {
  auto writer = coordinator->writer<Lease>();
  auto reader = worker->reader<Lease>(signal);
  write_leases(*writer, 1, 1);
  bus.kill("coordinator");
  EXPECT_TRUE(writer->write(lease(2)));
  EXPECT_THAT(leases(*reader), ElementsAre(1)) << "had been received before";
  auto late = worker->reader<Lease>(signal);
  EXPECT_THAT(late->take(), IsEmpty());

  auto successor = bus.join("coordinator");
  auto new_writer = successor->writer<Lease>();
  write_leases(*new_writer, 3, 3);
  EXPECT_THAT(leases(*reader), ElementsAre(3));
}

TEST_F(InMemoryBus, ReaderOfAKeyedTopicKeepsTheLastPerKey) {
  auto writer = worker->writer<WorkerStatus>();
  auto reader = coordinator->reader<WorkerStatus>(signal);
  for (std::uint64_t heartbeat = 1; heartbeat <= 3; ++heartbeat) {
    ASSERT_TRUE(writer->write(status(1, heartbeat)));
    ASSERT_TRUE(writer->write(status(2, heartbeat)));
  }
  EXPECT_THAT(reader->take(), ElementsAre(status(1, 3), status(2, 3)));
}

TEST_F(InMemoryBus, KeepAllWriterIsFullUntilTheReaderTakes) {
  auto writer = worker->writer<ResultBatch>();
  auto reader = coordinator->reader<ResultBatch>(signal);
  for (std::uint32_t i = 0; i < Topic<ResultBatch>::profile.depth; ++i) ASSERT_TRUE(writer->write({}));
  const WriteResult refused = writer->write({});
  EXPECT_EQ(refused.kind, WriteResult::Kind::full);
  EXPECT_THAT(refused.error, ::testing::HasSubstr("lamprey/4/result"));
  EXPECT_EQ(reader->take(1).size(), 1u);
  EXPECT_TRUE(writer->write({}));
  EXPECT_EQ(reader->take().size(), Topic<ResultBatch>::profile.depth);
}

TEST_F(InMemoryBus, DeadOrDisconnectedReaderDoesNotFillAWriter) {
  auto writer = worker->writer<ResultBatch>();
  auto reader = coordinator->reader<ResultBatch>(signal);
  while (writer->write({})) {
  }
  bus.disconnect("coordinator");
  EXPECT_TRUE(writer->write({}));
  bus.reconnect("coordinator");
  EXPECT_FALSE(writer->write({}));
  bus.kill("coordinator");
  EXPECT_TRUE(writer->write({}));
}

TEST_F(InMemoryBus, SampleBeyondItsBoundFailsAndSaysWhy) {
  auto writer = coordinator->writer<Lease>();
  Lease sample;
  sample.reason.assign(100'000, 'x');
  const WriteResult result = writer->write(sample);
  EXPECT_EQ(result.kind, WriteResult::Kind::failed);
  EXPECT_THAT(result.error, ::testing::HasSubstr("reason: size 100000, at most 65536"));
}

TEST_F(InMemoryBus, ObjectsMayOutliveBusAndParticipantInAnyOrder) {
  auto own_bus = std::make_unique<Bus>();
  auto participant = own_bus->join();
  auto writer = participant->writer<Lease>();
  auto reader = participant->reader<Lease>(signal);
  own_bus.reset();
  participant.reset();
  write_leases(*writer, 1, 1);
  EXPECT_THAT(leases(*reader), ElementsAre(1));
}

TEST_F(InMemoryBus, ManyThreadsLoseNothingAndKeepEachWritersOrder) {
  constexpr std::uint64_t writers = 4;
  constexpr std::uint64_t each = 300;
  auto reader = coordinator->reader<Lease>(signal);
  std::vector<std::jthread> threads;
  for (std::uint64_t number = 0; number < writers; ++number) {
    threads.emplace_back([this, number] {
      auto participant = bus.join("writer");
      auto writer = participant->writer<Lease>();
      for (std::uint64_t i = 0; i < each; ++i) {
        if (!writer->write(lease(number * each + i))) ADD_FAILURE() << "write failed";
      }
    });
  }
  std::vector<std::uint64_t> next(writers, 0);
  std::uint64_t received = 0;
  while (received < writers * each) {
    ASSERT_TRUE(signal->wait_for(std::chrono::seconds(60)));
    for (const auto number : leases(*reader)) {
      EXPECT_EQ(number % each, next[number / each]++);
      ++received;
    }
  }
}

}  // namespace
}  // namespace lamprey::messaging::in_memory
