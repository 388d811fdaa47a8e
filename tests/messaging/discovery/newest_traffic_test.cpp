#include "messaging/discovery/newest_traffic.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::messaging::discovery {
namespace {

using ::testing::ElementsAre;

Traffic traffic(std::uint8_t participant, double seconds) {
  return {.participant = {participant}, .seconds = seconds, .malformed = 0, .topics = {}};
}

TEST(NewestTraffic, KeepsTheNewestOfEach) {
  NewestTraffic newest;
  EXPECT_THAT(newest.after({traffic(2, 1), traffic(1, 5), traffic(2, 2)}), ElementsAre(traffic(1, 5), traffic(2, 2)));
  EXPECT_THAT(newest.after({traffic(1, 6)}), ElementsAre(traffic(1, 6), traffic(2, 2)));
  EXPECT_THAT(newest.after({}), ElementsAre(traffic(1, 6), traffic(2, 2)));
}

TEST(NewestTraffic, IsBoundedWhateverNamesComeFromTheNetwork) {
  NewestTraffic newest;
  std::vector<Traffic> flood(NewestTraffic::most_participants + 10);
  for (std::size_t i = 0; i < flood.size(); ++i) {
    for (std::size_t octet = 0; octet < 4; ++octet) {
      flood[i].participant[octet] = static_cast<std::uint8_t>(i >> (8 * octet));
    }
  }
  EXPECT_EQ(newest.after(flood).size(), NewestTraffic::most_participants);
  flood.resize(1);
  flood[0].seconds = 9;
  EXPECT_EQ(newest.after(flood).front().seconds, 9) << "who is known stays up to date";
}

}  // namespace
}  // namespace lamprey::messaging::discovery
