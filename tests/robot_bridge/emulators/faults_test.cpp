#include "robot_bridge/emulators/faults.hpp"

#include <gtest/gtest.h>

namespace lamprey::robot_bridge::emulators {
namespace {

using namespace std::chrono_literals;

Answer answer(std::vector<std::uint8_t> octets) {
  return {std::move(octets), 1s, 600us, 70us};
}

TEST(FaultsTest, WithoutFaultsAnAnswerLeavesAsItIs) {
  Faults faults(1);
  const auto result = faults.apply(answer({1, 2, 3}));
  ASSERT_TRUE(result);
  EXPECT_EQ(result->octets, (std::vector<std::uint8_t>{1, 2, 3}));
  EXPECT_EQ(result->asked, 1s);
  EXPECT_EQ(result->delay, 600us);
  EXPECT_EQ(result->gap, 70us);
}

TEST(FaultsTest, InSilenceNothingLeaves) {
  Faults faults(1);
  faults.silence = true;
  EXPECT_FALSE(faults.apply(answer({1, 2, 3})));
  faults.clear();
  EXPECT_TRUE(faults.apply(answer({1, 2, 3})));
}

TEST(FaultsTest, PartialAnswersLoseTheirSecondHalf) {
  Faults faults(1);
  faults.partial = true;
  EXPECT_EQ(faults.apply(answer({1, 2, 3, 4, 5}))->octets, (std::vector<std::uint8_t>{1, 2}));
  EXPECT_FALSE(faults.apply(answer({1})));
}

TEST(FaultsTest, SlowAnswersLeaveLater) {
  Faults faults(1);
  faults.slow = 30ms;
  EXPECT_EQ(faults.apply(answer({1}))->asked, 1030ms);
}

TEST(FaultsTest, NoiseIsOfItsSeedAndOfItsRate) {
  const std::vector<std::uint8_t> clean(10'000, 0x55);
  Faults first(7);
  Faults second(7);
  Faults other(8);
  for (Faults* faults : {&first, &second, &other}) faults->noise = 0.1;
  const auto disturbed = first.apply(answer(clean))->octets;
  EXPECT_EQ(disturbed, second.apply(answer(clean))->octets);
  EXPECT_NE(disturbed, other.apply(answer(clean))->octets);
  // Half of a tenth of the octets gets company: 500 of binomial standard deviation 22.
  EXPECT_NEAR(static_cast<double>(disturbed.size()), 10'500, 110);
  const auto untouched = std::count(disturbed.begin(), disturbed.end(), std::uint8_t{0x55});
  EXPECT_NEAR(static_cast<double>(untouched), 9'500, 115);
}

}  // namespace
}  // namespace lamprey::robot_bridge::emulators
