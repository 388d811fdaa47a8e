#include "worker/outbox.hpp"

#include "messaging/fragmentation.hpp"

#include <chrono>
#include <gtest/gtest.h>
#include <set>

namespace lamprey::worker {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Id128 database{1, 1};
constexpr Id128 sweep{2, 2};

messaging::JobResult result(std::uint64_t job, std::size_t trace = 0) {
  messaging::JobResult message;
  message.job = job;
  message.digest[0] = static_cast<std::uint8_t>(job + 1);
  message.outcome.trace.resize(trace);
  return message;
}

messaging::Acknowledgement answer(std::uint64_t job) {
  messaging::Acknowledgement message{sweep, job, {}, messaging::Verdict::committed, {}};
  message.digest[0] = static_cast<std::uint8_t>(job + 1);
  return message;
}

class OutboxTest : public testing::Test {
 protected:
  Clock::time_point now{seconds{100}};
  Outbox outbox;
};

TEST_F(OutboxTest, SmallResultsWaitForCompanyButNotForLong) {
  outbox.add(database, sweep, result(1), now);
  EXPECT_TRUE(outbox.due(now, false).empty());
  outbox.add(database, sweep, result(2), now + milliseconds{10});
  const auto batches = outbox.due(now + milliseconds{60}, false);
  ASSERT_EQ(batches.size(), 1U);
  EXPECT_EQ(batches[0].results.size(), 2U);
}

TEST_F(OutboxTest, FlushDoesNotWait) {
  outbox.add(database, sweep, result(1), now);
  EXPECT_EQ(outbox.due(now, true).size(), 1U);
}

TEST_F(OutboxTest, UnansweredResultsAreSentAgainWithGrowingPatience) {
  outbox.add(database, sweep, result(1), now);
  ASSERT_EQ(outbox.due(now, true).size(), 1U);
  EXPECT_TRUE(outbox.due(now + milliseconds{1900}, false).empty());
  ASSERT_EQ(outbox.due(now + seconds{2}, false).size(), 1U);
  EXPECT_TRUE(outbox.due(now + seconds{5}, false).empty());
  EXPECT_EQ(outbox.due(now + seconds{6}, false).size(), 1U);
}

TEST_F(OutboxTest, OnlyTheAnswerToThisResultForgetsIt) {
  outbox.add(database, sweep, result(1), now);
  auto other = answer(1);
  other.digest[0] = 99;
  EXPECT_FALSE(outbox.acknowledge(database, other));
  EXPECT_FALSE(outbox.acknowledge({7, 7}, answer(1)));
  EXPECT_EQ(outbox.held(), 1U);
  EXPECT_TRUE(outbox.acknowledge(database, answer(1)));
  EXPECT_EQ(outbox.held(), 0U);
  EXPECT_EQ(outbox.held_bytes(), 0U);
  EXPECT_FALSE(outbox.acknowledge(database, answer(1)));
}

TEST_F(OutboxTest, EverySampleStaysWithinItsBound) {
  for (std::uint64_t job = 0; job < 40; ++job) outbox.add(database, sweep, result(job, 200 * (job % 40)), now);
  std::set<std::uint64_t> jobs;
  for (const auto& batch : outbox.due(now, true)) {
    std::size_t bytes = 0;
    for (const auto& part : batch.results) {
      bytes += messaging::wire_bytes(part);
      jobs.insert(part.job);
    }
    EXPECT_LE(bytes, messaging::maximum_sample_bytes);
  }
  EXPECT_EQ(jobs.size(), 40U);
}

TEST_F(OutboxTest, MeasuresAreSplitOverSamplesAsTheTraceIs) {
  auto detailed = result(1, 10);
  for (std::uint32_t cycle = 0; cycle < 3000; ++cycle) {
    detailed.outcome.measures.push_back({"parameter_variation", cycle, 0.5});
  }
  outbox.add(database, sweep, detailed, now);
  const auto batches = outbox.due(now, true);
  EXPECT_GT(batches.size(), 1U);
  messaging::Assembler assembler;
  std::optional<messaging::JobResult> whole;
  for (const auto& batch : batches) {
    for (const auto& part : batch.results) {
      EXPECT_LE(messaging::wire_bytes(part), messaging::maximum_sample_bytes);
      whole = assembler.add(7, batch.sweep, part);
    }
  }
  EXPECT_EQ(whole, detailed);
}

TEST_F(OutboxTest, NoMoreIsInFlightThanAllowed) {
  Outbox bounded({.most_bytes_in_flight = 100'000});
  for (std::uint64_t job = 0; job < 20; ++job) bounded.add(database, sweep, result(job, 1000), now);
  std::set<std::uint64_t> sent;
  for (const auto& batch : bounded.due(now, true)) {
    for (const auto& part : batch.results) sent.insert(part.job);
  }
  EXPECT_GT(sent.size(), 0U);
  EXPECT_LE(sent.size(), 3U);
  EXPECT_TRUE(bounded.acknowledge(database, answer(*sent.begin())));
  EXPECT_FALSE(bounded.due(now, true).empty()) << "an answer makes room";
}

TEST_F(OutboxTest, ACoordinatorThatIsAwayDoesNotHoldUpAnother) {
  Outbox bounded({.most_bytes_in_flight = 50'000});
  for (std::uint64_t job = 0; job < 5; ++job) bounded.add({1, 0}, sweep, result(job, 1000), now);
  ASSERT_FALSE(bounded.due(now, true).empty());
  bounded.add({2, 0}, sweep, result(9, 1000), now);
  const auto batches = bounded.due(now, true);
  ASSERT_EQ(batches.size(), 1U);
  EXPECT_EQ(batches[0].origin.database, (Id128{2, 0}));
}

TEST_F(OutboxTest, NewCoordinatorGetsEverythingAgainAtOnce) {
  outbox.add(database, sweep, result(1), now);
  outbox.add({5, 5}, sweep, result(2), now);
  ASSERT_EQ(outbox.due(now, true).size(), 2U);
  outbox.resend_all(database);
  const auto batches = outbox.due(now, false);
  ASSERT_EQ(batches.size(), 1U);
  EXPECT_EQ(batches[0].origin.database, database);
}

TEST_F(OutboxTest, WhatCouldNotBeWrittenIsTriedAgainSoon) {
  outbox.add(database, sweep, result(1), now);
  const auto batches = outbox.due(now, true);
  outbox.postpone(batches.at(0), now);
  EXPECT_TRUE(outbox.due(now, false).empty());
  EXPECT_EQ(outbox.due(now + milliseconds{30}, false).size(), 1U);
}

TEST_F(OutboxTest, IsFullAtItsBound) {
  Outbox bounded({.most_bytes = 50'000});
  bounded.add(database, sweep, result(1, 500), now);
  EXPECT_FALSE(bounded.full());
  bounded.add(database, sweep, result(2, 1000), now);
  EXPECT_TRUE(bounded.full());
}

}  // namespace
}  // namespace lamprey::worker
