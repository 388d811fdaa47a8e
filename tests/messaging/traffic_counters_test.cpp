#include "messaging/traffic_counters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::messaging {
namespace {

using ::testing::ElementsAre;

TEST(TrafficCounters, CountEachTopicByItself) {
  TrafficCounters counters;
  counters.of("a").count_write(true);
  counters.of("b").count_read(3);
  counters.of("a").count_write(false);
  counters.of("a").count_write(true);
  const auto traffic = counters.so_far({1, 2}, 7);
  EXPECT_EQ(traffic.participant, (std::array<std::uint8_t, 16>{1, 2}));
  EXPECT_EQ(traffic.malformed, 7U);
  EXPECT_GE(traffic.seconds, 0);
  EXPECT_THAT(traffic.topics, ElementsAre(TopicTraffic{"a", 2, 1, 0}, TopicTraffic{"b", 0, 0, 3}));
}

TEST(TrafficCounters, StayWhereTheyAre) {
  TrafficCounters counters;
  TopicCounters& first = counters.of("0");
  static constexpr std::array names{"1", "2", "3", "4", "5", "6", "7", "8", "9"};
  for (const auto* name : names) counters.of(name);
  EXPECT_EQ(&counters.of("0"), &first);
}

}  // namespace
}  // namespace lamprey::messaging
