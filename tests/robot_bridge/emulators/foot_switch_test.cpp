#include "robot_bridge/emulators/foot_switch.hpp"

#include <gtest/gtest.h>
#include <stdexcept>

namespace lamprey::robot_bridge::emulators {
namespace {

constexpr FootSwitchForm letters{true, 6, 0, 31, 500, 2500};
constexpr FootSwitchForm bits{false, 8, 0, 252, 0, 4095};

TEST(FootSwitchTest, ReadsBothForms) {
  const FootSwitch a = parse_foot_switch("B=12<=1000", letters);
  EXPECT_EQ(a.input, 1U);
  EXPECT_EQ(a.servo, 12U);
  EXPECT_TRUE(a.closed_at(1000));
  EXPECT_FALSE(a.closed_at(1000.5));
  const FootSwitch b = parse_foot_switch("7=200>=2048", bits);
  EXPECT_EQ(b.input, 7U);
  EXPECT_EQ(b.servo, 200U);
  EXPECT_TRUE(b.closed_at(2048));
  EXPECT_FALSE(b.closed_at(2047));
}

TEST(FootSwitchTest, SaysWhatIsWrong) {
  const auto complaint = [](const char* text) -> std::string {
    try {
      parse_foot_switch(text, letters);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_EQ(complaint("A=0"),
            "foot 'A=0': expected INPUT=SERVO<=THRESHOLD or INPUT=SERVO>=THRESHOLD, such as 'A=0<=500'");
  EXPECT_EQ(complaint(""), "foot '': expected INPUT=SERVO<=THRESHOLD or INPUT=SERVO>=THRESHOLD, such as 'A=0<=500'");
  EXPECT_EQ(complaint("G=0<=1000"), "foot 'G=0<=1000': input 'G' is not in A..F");
  EXPECT_EQ(complaint("A=32<=1000"), "foot 'A=32<=1000': servo '32' is not in 0..31");
  EXPECT_EQ(complaint("A=-1<=1000"), "foot 'A=-1<=1000': servo '-1' is not in 0..31");
  EXPECT_EQ(complaint("A=0>=2501"), "foot 'A=0>=2501': threshold '2501' is not in 500..2500");
  EXPECT_EQ(complaint("A=0<=1e3"), "foot 'A=0<=1e3': threshold '1e3' is not in 500..2500");
}

}  // namespace
}  // namespace lamprey::robot_bridge::emulators
