#include "messaging/fragmentation.hpp"

#include "tests/messaging/example_samples.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace lamprey::messaging {
namespace {

constexpr std::uint64_t worker = 7;
const Id128 sweep{1, 2};

JobResult whole_result(std::size_t rows, std::uint64_t seed = 1, std::size_t measures = 0) {
  testing::Values values(seed);
  JobResult result = testing::example_result(values, rows, measures);
  result.kind = ResultKind::done;
  result.fragment = 0;
  result.fragments = 1;
  return result;
}

/// Two of its fragments are enough to be told apart.
constexpr std::size_t long_trace = 6000;

TEST(Fragmentation, ShortResultStaysInOnePiece) {
  const JobResult result = whole_result(10);
  EXPECT_THAT(fragments(result), ::testing::ElementsAre(result));
}

TEST(Fragmentation, EveryFragmentFitsASample) {
  for (const std::size_t rows : {std::size_t{0}, std::size_t{1}, std::size_t{1000}, std::size_t{1700},
                                 std::size_t{1800}, std::size_t{1900}, std::size_t{100'000}}) {
    JobResult result = whole_result(rows);
    result.reason.assign(100'000, 'r');
    for (const auto& fragment : fragments(result)) EXPECT_LE(wire_bytes(fragment), maximum_sample_bytes - 256);
  }
}

// A long job on a robot has megabytes of them.
TEST(Fragmentation, RecordingsAreCutOverFragmentsBehindTraceAndMeasures) {
  for (const std::size_t octets : {std::size_t{1}, std::size_t{60'000}, std::size_t{70'000}, std::size_t{3'000'000}}) {
    JobResult result = whole_result(100, 1, 100);
    result.recording = testing::Values(5).octets(octets);
    const auto parts = fragments(result);
    EXPECT_EQ(parts.size() > 1, octets > 50'000);
    Assembler assembler;
    std::optional<JobResult> assembled;
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
      EXPECT_LE(wire_bytes(*part), maximum_sample_bytes - 256);
      assembled = assembler.add(worker, sweep, *part);
    }
    EXPECT_EQ(assembled, result);
  }
}

// Neither has a digest.
TEST(Fragmentation, TwoAttemptsThatFailedAreNotPutTogether) {
  JobResult first = whole_result(0);
  first.kind = ResultKind::failed;
  first.digest = {};
  first.recording.assign(100'000, 1);
  JobResult second = first;
  ++second.lease;
  second.recording.assign(100'000, 2);
  Assembler assembler;
  EXPECT_FALSE(assembler.add(worker, sweep, fragments(first).front()));
  for (const auto& part : fragments(second)) {
    if (const auto assembled = assembler.add(worker, sweep, part)) {
      EXPECT_EQ(*assembled, second);
    }
  }
  EXPECT_EQ(assembler.held_bytes(), 0u);
}

// A run with `record: details` has as many measures as rows of its trace.
TEST(Fragmentation, MeasuresAreCutOverFragmentsLikeTheTrace) {
  for (const auto& [rows, measures] :
       {std::pair<std::size_t, std::size_t>{0, 5000}, {10, 10}, {long_trace, long_trace}, {1790, 10}}) {
    const JobResult result = whole_result(rows, 1, measures);
    const auto parts = fragments(result);
    EXPECT_EQ(parts.size() > 1, rows + measures > 1700);
    Assembler assembler;
    std::optional<JobResult> assembled;
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
      EXPECT_LE(wire_bytes(*part), maximum_sample_bytes - 256);
      EXPECT_EQ(part->fragments, parts.size());
      assembled = assembler.add(worker, sweep, *part);
    }
    EXPECT_EQ(assembled, result);
    EXPECT_EQ(assembler.held_bytes(), 0u);
  }
}

TEST(Fragmentation, AnyOrderWithDuplicatesGivesTheWholeExactlyOnce) {
  std::mt19937_64 random(2006);
  for (const std::size_t rows : {std::size_t{1}, std::size_t{1800}, std::size_t{long_trace}, std::size_t{40'000}}) {
    for (int repetition = 0; repetition < 10; ++repetition) {
      const JobResult result = whole_result(rows, 1, rows / 2);
      auto parts = fragments(result);
      const auto copies = parts;
      parts.insert(parts.end(), copies.begin(), copies.end());
      std::shuffle(parts.begin(), parts.end(), random);
      // Cut off behind the last first occurrence, so that no second round begins.
      Assembler assembler;
      std::vector<JobResult> results;
      for (const auto& part : parts) {
        if (auto assembled = assembler.add(worker, sweep, part)) {
          results.push_back(*assembled);
          break;
        }
      }
      EXPECT_THAT(results, ::testing::ElementsAre(result));
      EXPECT_EQ(assembler.held_bytes(), 0u);
    }
  }
}

TEST(Fragmentation, InterleavedWorkersSweepsAndJobsAreKeptApart) {
  const JobResult a = whole_result(long_trace, 1);
  JobResult b = whole_result(long_trace, 2);
  b.job = a.job;
  Assembler assembler;
  std::vector<JobResult> from_one;
  std::vector<JobResult> from_other;
  const auto parts_a = fragments(a);
  const auto parts_b = fragments(b);
  ASSERT_GT(parts_a.size(), 2u);
  for (std::size_t i = 0; i < parts_a.size(); ++i) {
    if (auto result = assembler.add(1, sweep, parts_a[i])) from_one.push_back(*result);
    if (auto result = assembler.add(2, sweep, parts_b[i])) from_other.push_back(*result);
  }
  EXPECT_THAT(from_one, ::testing::ElementsAre(a));
  EXPECT_THAT(from_other, ::testing::ElementsAre(b));
}

TEST(Fragmentation, ContradictingFragmentStartsTheResultAnew) {
  const JobResult old = whole_result(long_trace, 1);
  JobResult replacement = whole_result(long_trace, 2);
  replacement.job = old.job;
  Assembler assembler;
  EXPECT_FALSE(assembler.add(worker, sweep, fragments(old)[0]));
  const auto parts = fragments(replacement);
  std::optional<JobResult> result;
  for (const auto& part : parts) result = assembler.add(worker, sweep, part);
  EXPECT_EQ(result, replacement);
  EXPECT_EQ(assembler.held_bytes(), 0u);
}

TEST(Fragmentation, ImpossibleFragmentsAreIgnored) {
  Assembler assembler;
  JobResult fragment = whole_result(1);
  fragment.fragments = 0;
  EXPECT_FALSE(assembler.add(worker, sweep, fragment));
  fragment.fragments = 4;
  fragment.fragment = 4;
  EXPECT_FALSE(assembler.add(worker, sweep, fragment));
  fragment.fragments = std::numeric_limits<std::uint32_t>::max();
  fragment.fragment = fragment.fragments - 1;
  EXPECT_FALSE(assembler.add(worker, sweep, fragment));
  JobResult oversized = whole_result(10'000);
  oversized.fragments = 2;
  EXPECT_FALSE(assembler.add(worker, sweep, oversized));
  EXPECT_EQ(assembler.held_bytes(), 0u);
}

TEST(Fragmentation, BoundDropsTheOldestUnfinishedResult) {
  Assembler assembler(3 * maximum_sample_bytes);
  JobResult first = whole_result(long_trace, 1);
  const auto first_parts = fragments(first);
  EXPECT_FALSE(assembler.add(worker, sweep, first_parts[0]));
  for (std::uint64_t job = 100; job < 150; ++job) {
    JobResult other = whole_result(long_trace, job);
    other.job = job;
    EXPECT_FALSE(assembler.add(worker, sweep, fragments(other)[0]));
    EXPECT_LE(assembler.held_bytes(), 3 * maximum_sample_bytes);
  }
  // The first one's head start is forgotten: all of its fragments are needed again.
  std::optional<JobResult> result;
  for (std::size_t i = 1; i < first_parts.size(); ++i) EXPECT_FALSE(assembler.add(worker, sweep, first_parts[i]));
  EXPECT_EQ(assembler.add(worker, sweep, first_parts[0]), first);
}

TEST(Fragmentation, OneResultMayBeLongerThanTheBound) {
  Assembler assembler(maximum_sample_bytes / 2);
  const JobResult whole = whole_result(long_trace);
  const auto parts = fragments(whole);
  for (std::size_t i = 1; i < parts.size(); ++i) EXPECT_FALSE(assembler.add(worker, sweep, parts[i]));
  EXPECT_EQ(assembler.incomplete(), 1u);
  EXPECT_EQ(assembler.add(worker, sweep, parts[0]), whole);
  EXPECT_EQ(assembler.incomplete(), 0u);
}

}  // namespace
}  // namespace lamprey::messaging
