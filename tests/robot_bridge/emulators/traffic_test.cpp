#include "robot_bridge/emulators/traffic.hpp"

#include <gtest/gtest.h>

namespace lamprey::robot_bridge::emulators {
namespace {

using namespace std::chrono_literals;

TEST(TrafficTest, ThePeakIsTheFullestSecondWhereverItBegins) {
  Traffic traffic;
  for (const auto time : {0ms, 900ms, 950ms, 1100ms, 1899ms, 1900ms, 5000ms}) traffic.passed(time);
  EXPECT_EQ(traffic.octets(), 7U);
  EXPECT_EQ(traffic.peak_per_second(), 4U);  // 900 to 1899; and 950 to 1900
}

}  // namespace
}  // namespace lamprey::robot_bridge::emulators
