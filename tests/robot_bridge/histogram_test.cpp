#include "robot_bridge/histogram.hpp"

#include <gtest/gtest.h>

namespace lamprey::robot_bridge {
namespace {

using namespace std::chrono_literals;

TEST(Histogram, EmptyOneHasNothing) {
  EXPECT_EQ(Histogram().quantile(0.5), 0us);
  EXPECT_EQ(Histogram().largest(), 0us);
}

TEST(Histogram, QuantilesAreRightToASixteenth) {
  Histogram histogram;
  for (int i = 1; i <= 100'000; ++i) histogram.add(std::chrono::microseconds(i));
  for (const double share : {0.001, 0.01, 0.25, 0.5, 0.9, 0.99, 0.999}) {
    const double exact = share * 100'000;
    const auto found = static_cast<double>(histogram.quantile(share).count());
    EXPECT_GE(found, exact);
    EXPECT_LE(found, exact * (1 + 1.0 / 16) + 1);
  }
  EXPECT_EQ(histogram.quantile(1), 100'000us);
  EXPECT_EQ(histogram.largest(), 100'000us);
  EXPECT_EQ(histogram.count(), 100'000U);
}

TEST(Histogram, SmallDurationsAreExact) {
  for (int i = 0; i < 32; ++i) {
    Histogram histogram;
    histogram.add(std::chrono::microseconds(i));
    histogram.add(1h);
    EXPECT_EQ(histogram.quantile(0.5), std::chrono::microseconds(i));
  }
}

TEST(Histogram, TakesWhatNoClockShouldGive) {
  Histogram histogram;
  histogram.add(-1s);
  histogram.add(1000h);
  EXPECT_EQ(histogram.count(), 2U);
  EXPECT_EQ(histogram.quantile(0.5), 0us);
  EXPECT_EQ(histogram.largest(), 1000h);
}

}  // namespace
}  // namespace lamprey::robot_bridge
