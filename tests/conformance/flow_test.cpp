#include "messaging/qos.hpp"
#include "tests/conformance/world.hpp"

#include <cstdint>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <thread>
#include <vector>

namespace lamprey::messaging::conformance {
namespace {

/// About 20 KB on the wire.
ResultBatch batch(std::uint64_t sequence) {
  ResultBatch sample;
  sample.sequence = sequence;
  sample.results.resize(1);
  sample.results[0].job = sequence;
  sample.results[0].outcome.trace.resize(500);
  return sample;
}

/// The sequence numbers without those of the marker, 0.
std::vector<std::uint64_t> sequences(const std::vector<ResultBatch>& batches) {
  std::vector<std::uint64_t> all;
  for (const auto& sample : batches) {
    if (sample.sequence != 0) all.push_back(sample.sequence);
  }
  return all;
}

std::vector<std::uint64_t> one_to(std::uint64_t last) {
  std::vector<std::uint64_t> all;
  for (std::uint64_t i = 1; i <= last; ++i) all.push_back(i);
  return all;
}

auto until(std::uint64_t last) {
  return [last](const std::vector<ResultBatch>& all) { return !all.empty() && all.back().sequence == last; };
}

class Flow : public World {};

TEST_P(Flow, TwoThousandBatchesWrittenAndTakenByTwoThreadsArriveCompleteAndInOrder) {
  constexpr std::uint64_t count = 2000;
  auto from = join_writer();
  auto to = join_reader();
  auto writer = from->writer<ResultBatch>();
  Inbox<ResultBatch> inbox(*to);
  meet(*writer, inbox, batch(0));
  std::jthread thread([&] {
    for (std::uint64_t i = 1; i <= count; ++i) write(*writer, batch(i));
  });
  EXPECT_TRUE(inbox.take_until(until(count)));
  EXPECT_EQ(sequences(inbox.samples), one_to(count));
}

/// Writes batches 1, 2, … until the writer is full, at most so many; the last that was written.
std::uint64_t write_while_nobody_takes(Writer<ResultBatch>& writer, std::uint64_t most) {
  for (std::uint64_t i = 1; i <= most; ++i) {
    const WriteResult result = writer.write(batch(i));
    if (result) continue;
    EXPECT_EQ(result.kind, WriteResult::Kind::full) << result.error;
    return i - 1;
  }
  return most;
}

TEST_P(Flow, ReaderThatTakesLateLosesNothing) {
  auto from = join_writer();
  auto to = join_reader();
  auto writer = from->writer<ResultBatch>();
  Inbox<ResultBatch> inbox(*to);
  meet(*writer, inbox, batch(0));
  const std::uint64_t written = write_while_nobody_takes(*writer, 1500);
  EXPECT_GE(written, 8u) << "so little in flight cannot be fast";
  const std::uint64_t count = written + 200;
  std::jthread thread([&] {
    for (std::uint64_t i = written + 1; i <= count; ++i) write(*writer, batch(i));
  });
  EXPECT_TRUE(inbox.take_until(until(count)));
  EXPECT_EQ(sequences(inbox.samples), one_to(count));
}

TEST_P(Flow, ReaderThatNeverTakesHoldsABoundedNumber) {
  auto from = join_writer();
  auto to = join_reader();
  auto writer = from->writer<Request>();
  Inbox<Request> inbox(*to);
  Request request;
  write(*writer, request);
  ASSERT_TRUE(inbox.take_until_size(1));
  inbox.samples.clear();
  constexpr std::uint64_t written = 6000;
  for (request.correlation = 1; request.correlation <= written; ++request.correlation) {
    static_cast<void>(writer->write(request));
  }
  inbox.take();
  EXPECT_LE(inbox.samples.size(), 4096u);
}

TEST_P(Flow, UntakenResultsDoNotHoldUpOtherTopics) {
  auto from = join_writer();
  auto to = join_reader();
  auto results = from->writer<ResultBatch>();
  auto requests = from->writer<Request>();
  Inbox<ResultBatch> result_inbox(*to);
  Inbox<Request> request_inbox(*to);
  meet(*results, result_inbox, batch(0));
  write_while_nobody_takes(*results, 1500);
  Request request;
  request.correlation = 17;
  write(*requests, request);
  EXPECT_TRUE(request_inbox.take_until_size(1));
}

TEST_P(Flow, ReaderThatIsDestroyedFullLetsTheWriterGoOn) {
  auto from = join_writer();
  auto to = join_reader();
  auto writer = from->writer<ResultBatch>();
  auto inbox = std::make_unique<Inbox<ResultBatch>>(*to);
  meet(*writer, *inbox, batch(0));
  write_while_nobody_takes(*writer, 1500);
  inbox.reset();
  write(*writer, batch(2));
}

// Fast DDS 2.9 must not be let to forget a volatile writer's samples while it sends them again (fastdds/qos.hpp): its
// threads would wait for each other for ever.
TEST_P(Flow, ReadersThatLeaveWhileSamplesAreOnTheirWayHangNobodyUp) {
  auto from = join_writer();
  auto to = join_reader();
  for (std::uint64_t round = 1; round <= 10; ++round) {
    auto writer = from->writer<ResultBatch>(Partition::of(round));
    Inbox<ResultBatch> inbox(*to, Partition::of(round));
    meet(*writer, inbox, batch(0));
    write_while_nobody_takes(*writer, 1500);
  }
}

INSTANTIATE_TEST_SUITE_P(Port, Flow, ::testing::ValuesIn(all_pairs()), pair_name);

}  // namespace
}  // namespace lamprey::messaging::conformance
