#include "experiment/job_ranges.hpp"

#include <gtest/gtest.h>
#include <random>
#include <set>

namespace lamprey::experiment {
namespace {

using Range = JobRanges::Range;
using Ranges = std::vector<Range>;

JobRanges of(std::initializer_list<Range> ranges) {
  JobRanges set;
  for (const auto& [first, count] : ranges) set.add(first, count);
  return set;
}

TEST(JobRanges, StartsEmpty) {
  const JobRanges set;
  EXPECT_TRUE(set.empty());
  EXPECT_EQ(set.size(), 0U);
  EXPECT_FALSE(set.contains(0));
}

TEST(JobRanges, JoinsRangesThatOverlapOrTouch) {
  EXPECT_EQ(of({{0, 5}, {5, 5}}).ranges(), (Ranges{{0, 10}}));
  EXPECT_EQ(of({{5, 5}, {0, 5}}).ranges(), (Ranges{{0, 10}}));
  EXPECT_EQ(of({{0, 6}, {4, 2}}).ranges(), (Ranges{{0, 6}}));
  EXPECT_EQ(of({{0, 2}, {4, 2}, {8, 2}, {1, 8}}).ranges(), (Ranges{{0, 10}}));
  EXPECT_EQ(of({{0, 4}, {5, 5}}).ranges(), (Ranges{{0, 4}, {5, 5}}));
}

TEST(JobRanges, ARangeOfNoneChangesNothing) {
  auto set = of({{3, 4}});
  set.add(10, 0);
  set.remove(4, 0);
  EXPECT_EQ(set, of({{3, 4}}));
}

TEST(JobRanges, RemovingFromTheMiddleLeavesBothEnds) {
  auto set = of({{0, 10}});
  set.remove(3, 4);
  EXPECT_EQ(set.ranges(), (Ranges{{0, 3}, {7, 3}}));
  EXPECT_EQ(set.size(), 6U);
  set.remove(0, 100);
  EXPECT_TRUE(set.empty());
}

TEST(JobRanges, TakesAJobOnce) {
  auto set = of({{0, 3}});
  EXPECT_TRUE(set.take(1));
  EXPECT_FALSE(set.take(1));
  EXPECT_EQ(set, of({{0, 1}, {2, 1}}));
}

TEST(JobRanges, TakesTheLowestAcrossGapsAndNoMoreThanThereAre) {
  auto set = of({{2, 2}, {10, 3}});
  EXPECT_EQ(set.take_lowest(3), of({{2, 2}, {10, 1}}));
  EXPECT_EQ(set, of({{11, 2}}));
  EXPECT_EQ(set.take_lowest(100), of({{11, 2}}));
  EXPECT_TRUE(set.empty());
  EXPECT_TRUE(set.take_lowest(1).empty());
}

TEST(JobRanges, IntersectionHoldsWhatBothHold) {
  EXPECT_EQ(of({{0, 5}, {10, 5}}).intersection(of({{3, 9}})), of({{3, 2}, {10, 2}}));
  EXPECT_TRUE(of({{0, 5}}).intersection(of({{5, 5}})).empty());
}

/// Against a plain set of numbers, by the same random operations.
TEST(JobRanges, AgreesWithAPlainSet) {
  std::mt19937_64 generator(1);
  const auto below = [&](std::uint64_t bound) { return generator() % bound; };
  JobRanges set;
  std::set<std::uint64_t> plain;
  for (int i = 0; i < 5000; ++i) {
    const std::uint64_t first = below(60);
    const std::uint64_t count = below(12);
    switch (below(4)) {
      case 0:
        set.add(first, count);
        for (std::uint64_t n = first; n < first + count; ++n) plain.insert(n);
        break;
      case 1:
        set.remove(first, count);
        for (std::uint64_t n = first; n < first + count; ++n) plain.erase(n);
        break;
      case 2:
        ASSERT_EQ(set.take(first), plain.erase(first) == 1);
        break;
      default: {
        const JobRanges taken = set.take_lowest(count / 4);
        for (const auto& range : taken.ranges()) {
          for (std::uint64_t n = range.first; n < range.first + range.count; ++n) {
            ASSERT_EQ(*plain.begin(), n);
            plain.erase(n);
          }
        }
      }
    }
    ASSERT_EQ(set.size(), plain.size());
    std::uint64_t last_end = 0;
    for (const auto& range : set.ranges()) {
      ASSERT_GT(range.count, 0U);
      ASSERT_TRUE(last_end == 0 || range.first > last_end) << "ranges neither touch nor overlap";
      last_end = range.first + range.count;
    }
    for (std::uint64_t n = 0; n < 75; ++n) ASSERT_EQ(set.contains(n), plain.contains(n)) << n;
  }
}

TEST(JobRanges, SetsAreAddedAndRemoved) {
  auto set = of({{0, 4}});
  set.add(of({{4, 2}, {9, 1}}));
  EXPECT_EQ(set, of({{0, 6}, {9, 1}}));
  set.remove(of({{1, 1}, {5, 10}}));
  EXPECT_EQ(set, of({{0, 1}, {2, 3}}));
}

}  // namespace
}  // namespace lamprey::experiment
