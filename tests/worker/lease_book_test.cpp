#include "worker/lease_book.hpp"

#include "experiment/sweep.hpp"

#include <gtest/gtest.h>

namespace lamprey::worker {
namespace {

constexpr Id128 database{1, 1};
constexpr Id128 sweep{2, 2};
constexpr auto any_sweep = [](const Id128&, const Id128&) { return true; };

messaging::Lease grant(std::uint64_t lease, std::uint64_t first, std::uint64_t count) {
  messaging::Lease message;
  message.origin.database = database;
  message.origin.epoch = 4;
  message.lease = lease;
  message.sweep = sweep;
  message.ranges = {{first, count}};
  return message;
}

TEST(LeaseBook, StartsEachJobOnceOldestLeaseFirst) {
  LeaseBook book;
  ASSERT_TRUE(book.grant(grant(9, 0, 2)));
  ASSERT_TRUE(book.grant(grant(1, 10, 3)));
  std::vector<std::uint64_t> jobs;
  for (const auto& start : book.start(4, any_sweep)) jobs.push_back(start.job);
  EXPECT_EQ(jobs, (std::vector<std::uint64_t>{0, 1, 10, 11}));
  jobs.clear();
  for (const auto& start : book.start(4, any_sweep)) jobs.push_back(start.job);
  EXPECT_EQ(jobs, (std::vector<std::uint64_t>{12}));
}

TEST(LeaseBook, RepeatedGrantChangesNothing) {
  LeaseBook book;
  ASSERT_TRUE(book.grant(grant(1, 0, 2)));
  book.start(2, any_sweep);
  EXPECT_FALSE(book.grant(grant(1, 0, 2)));
  EXPECT_TRUE(book.start(2, any_sweep).empty());
}

TEST(LeaseBook, EndsWhenEveryJobHasItsAnswerAndIsNotTakenAgain) {
  LeaseBook book;
  ASSERT_TRUE(book.grant(grant(1, 0, 2)));
  book.start(2, any_sweep);
  book.settled(database, sweep, 1);
  ASSERT_EQ(book.held().size(), 1U);
  EXPECT_EQ(book.held()[0].remaining, (std::vector<messaging::JobRange>{{0, 1}}));
  EXPECT_EQ(book.held()[0].epoch, 4U);
  book.settled(database, sweep, 0);
  EXPECT_TRUE(book.empty());
  EXPECT_FALSE(book.grant(grant(1, 0, 2)));
}

TEST(LeaseBook, RevokedLeaseDropsWhatHasNotStarted) {
  LeaseBook book;
  ASSERT_TRUE(book.grant(grant(1, 0, 5)));
  book.start(2, any_sweep);
  EXPECT_TRUE(book.revoke({database, 1}));
  EXPECT_FALSE(book.revoke({database, 1}));
  EXPECT_TRUE(book.start(9, any_sweep).empty());
  EXPECT_TRUE(book.held().empty());
}

TEST(LeaseBook, LeasesOfTwoDatabasesMayHaveTheSameNumber) {
  LeaseBook book;
  auto other = grant(1, 0, 5);
  other.origin.database = {9, 9};
  EXPECT_TRUE(book.grant(grant(1, 0, 5)));
  EXPECT_TRUE(book.grant(other));
  book.settled({9, 9}, sweep, 0);
  EXPECT_EQ(book.held().size(), 2U);
  EXPECT_EQ(book.held()[0].remaining, (std::vector<messaging::JobRange>{{0, 5}}));
}

TEST(LeaseBook, JobsOfASweepThatIsNotKnownYetWait) {
  LeaseBook book;
  ASSERT_TRUE(book.grant(grant(1, 0, 5)));
  EXPECT_TRUE(book.start(9, [](const Id128&, const Id128&) { return false; }).empty());
  EXPECT_EQ(book.start(9, any_sweep).size(), 5U);
}

TEST(LeaseBook, ForgottenSweepIsNoLongerHeld) {
  LeaseBook book;
  ASSERT_TRUE(book.grant(grant(1, 0, 5)));
  auto other = grant(2, 0, 5);
  other.sweep = {8, 8};
  ASSERT_TRUE(book.grant(other));
  book.forget_sweep(database, sweep);
  ASSERT_EQ(book.held().size(), 1U);
  EXPECT_EQ(book.held()[0].lease, 2U);
}

TEST(LeaseBook, ImpossibleRangesAreIgnored) {
  LeaseBook book;
  EXPECT_FALSE(book.grant(grant(1, 0, 0)));
  EXPECT_FALSE(book.grant(grant(2, ~std::uint64_t{0}, 5)));
  EXPECT_FALSE(book.grant(grant(3, 5, ~std::uint64_t{0})));
  EXPECT_TRUE(book.empty());
}

}  // namespace
}  // namespace lamprey::worker
