#include "client/output/formatting.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace lamprey::client::output {
namespace {

TEST(Formatting, ThousandsAreSeparatedOnlyBetweenDigits) {
  EXPECT_EQ(with_thousands(0), "0");
  EXPECT_EQ(with_thousands(999), "999");
  EXPECT_EQ(with_thousands(1000), "1,000");
  EXPECT_EQ(with_thousands(41472000), "41,472,000");
  EXPECT_EQ(with_thousands(std::numeric_limits<std::uint64_t>::max()), "18,446,744,073,709,551,615");
}

TEST(Formatting, ShortestNumbersReadBackToTheSameDouble) {
  EXPECT_EQ(shortest(83), "83");
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(std::stod(shortest(0.1 + 0.2)), 0.1 + 0.2);
}

TEST(Formatting, RoundedNumbersHaveSixSignificantDigitsAtMost) {
  EXPECT_EQ(rounded(0.8433333333333334), "0.843333");
  EXPECT_EQ(rounded(83), "83");
  EXPECT_EQ(rounded(188.40000000000001), "188.4");
}

TEST(Formatting, DurationsHaveTwoUnitsAtMost) {
  EXPECT_EQ(duration(0), "0 s");
  EXPECT_EQ(duration(0.44), "0.4 s");
  EXPECT_EQ(duration(9.96), "10 s");
  EXPECT_EQ(duration(59.4), "59 s");
  EXPECT_EQ(duration(59.6), "1 min");
  EXPECT_EQ(duration(185), "3 min 5 s");
  EXPECT_EQ(duration(3599.7), "1 h");
  EXPECT_EQ(duration(7800), "2 h 10 min");
  EXPECT_EQ(duration(3.0 * 86400 + 4 * 3600), "3 d 4 h");
}

TEST(Formatting, DurationsThatNobodyKnowsAreQuestionMarks) {
  EXPECT_EQ(duration(-1), "?");
  EXPECT_EQ(duration(std::numeric_limits<double>::infinity()), "?");
  EXPECT_EQ(duration(std::numeric_limits<double>::quiet_NaN()), "?");
}

TEST(Formatting, SlowRatesAreGivenPerMinuteOrHour) {
  EXPECT_EQ(rate(612.3), "612 jobs/s");
  EXPECT_EQ(rate(2.54), "2.5 jobs/s");
  EXPECT_EQ(rate(0.2), "12 jobs/min");
  EXPECT_EQ(rate(0.001), "3.6 jobs/h");
  EXPECT_EQ(rate(0), "0 jobs/s");
}

TEST(Formatting, OneIsSingular) {
  EXPECT_EQ(counted(1, "job", "jobs"), "1 job");
  EXPECT_EQ(counted(0, "job", "jobs"), "0 jobs");
  EXPECT_EQ(counted(1234, "job", "jobs"), "1,234 jobs");
}

TEST(Formatting, WidthCountsCharactersAndNotBytes) {
  EXPECT_EQ(width("─×…"), 3U);
}

TEST(Formatting, CutTextNeverExceedsItsColumnsNorSplitsACharacter) {
  EXPECT_EQ(cut("abcdef", 6, "…"), "abcdef");
  EXPECT_EQ(cut("abcdef", 5, "…"), "abcd…");
  EXPECT_EQ(cut("××××", 3, "…"), "××…");
  EXPECT_EQ(cut("abcdef", 5, "..."), "ab...");
}

TEST(Formatting, WrappedLinesKeepWordsWhole) {
  EXPECT_EQ(wrap("one two three", 7), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrap("incomprehensibility is", 5), (std::vector<std::string>{"incomprehensibility", "is"}));
  EXPECT_TRUE(wrap("  ", 5).empty());
}

TEST(Formatting, LongListsLoseTheirMiddleAndKeepTheirLastValue) {
  EXPECT_EQ(list_in_short({"1", "2", "3"}, 20, "..."), "1, 2, 3");
  EXPECT_EQ(list_in_short({"1", "2", "3", "4", "5", "6", "7", "8"}, 16, "..."), "1, 2, 3, ..., 8");
  std::vector<std::string> many(100'000, "7");
  many.back() = "9";
  EXPECT_TRUE(list_in_short(many, 20, "...").ends_with(", ..., 9"));
  EXPECT_LE(list_in_short(many, 20, "...").size(), 20U);
}

}  // namespace
}  // namespace lamprey::client::output
