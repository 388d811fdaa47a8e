#include "robot_bridge/drivers/sent_position.hpp"

#include "robot_bridge/driver.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace lamprey::robot_bridge::drivers {
namespace {

constexpr Joint joint{.channel = 0,
                      .minimum = 600,
                      .centre = 1000,
                      .maximum = 1800,
                      .per_unit = 33.3,
                      .direction = 1,
                      .offset = 4,
                      .slew_rate = 5000};

TEST(SentPosition, IsTheNearestWholeNumberAndKeepsWhatWasAskedFor) {
  EXPECT_EQ(sent_position(joint, 0, 11), (SentPosition{.device = 1037, .units = 11}));
  EXPECT_EQ(sent_position(joint, 0, 10.5), (SentPosition{.device = 1021, .units = 10.5}));
}

TEST(SentPosition, NeverLeavesTheCalibratedRange) {
  const auto above = sent_position(joint, 0, 1e300);
  EXPECT_EQ(above.device, 1800);
  EXPECT_EQ(above.units, joint.to_units(1800));
  const auto below = sent_position(joint, 0, -1e300);
  EXPECT_EQ(below.device, 600);
  EXPECT_EQ(below.units, joint.to_units(600));
}

TEST(SentPosition, DoesNotRoundOutOfARangeThatEndsBetweenWholeNumbers) {
  Joint narrow = joint;
  narrow.minimum = 1000.6;
  narrow.maximum = 1799.5;
  EXPECT_EQ(sent_position(narrow, 0, 0).device, 1001);
  EXPECT_EQ(sent_position(narrow, 0, 1000).device, 1799);
}

TEST(SentPosition, TurnsWithTheServosDirection) {
  Joint turned = joint;
  turned.direction = -1;
  turned.per_unit = 50;
  EXPECT_EQ(sent_position(turned, 0, 12).device, 904);
  EXPECT_EQ(turned.to_units(904), 12);
}

TEST(SentPosition, RefusesWhatIsNoNumber) {
  for (const double none : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    try {
      sent_position(joint, 1, none);
      ADD_FAILURE() << "sent " << none;
    } catch (const DriverError& error) {
      EXPECT_EQ(error.kind(), DriverError::Kind::refused);
      EXPECT_TRUE(std::string(error.what()).starts_with("front right vertical can't go to")) << error.what();
    }
  }
}

TEST(Joint, StaysInItsRangeWithWhatIsNoNumber) {
  const double device = joint.to_device(std::numeric_limits<double>::quiet_NaN());
  EXPECT_GE(device, joint.minimum);
  EXPECT_LE(device, joint.maximum);
}

}  // namespace
}  // namespace lamprey::robot_bridge::drivers
