#include "robot_bridge/drivers/feet.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::robot_bridge::drivers {
namespace {

using namespace science::robots;

bool never_asked(std::int32_t) {
  ADD_FAILURE() << "there are no contacts";
  return false;
}

TEST(Feet, AreDownAtTheGroundLevelWhereThereIsNoContact) {
  Pose pose = standing_pose();
  EXPECT_EQ(feet_down(Calibration{}, pose, never_asked), 0b1111U);
  pose[vertical_servo(front_right)] = 11;
  pose[vertical_servo(back_left)] = 9;
  EXPECT_EQ(feet_down(Calibration{}, pose, never_asked), 0b1101U);
}

TEST(Feet, AreNotLiftedByASensorsLastDigit) {
  Pose pose = standing_pose();
  pose[vertical_servo(front_left)] = 10.4;
  pose[vertical_servo(back_right)] = 10.6;
  EXPECT_EQ(feet_down(Calibration{}, pose, never_asked), 0b0111U);
}

TEST(Feet, AreDownWhereTheirContactIsClosed) {
  Calibration calibration;
  calibration.feet[front_left] = FootContact{.channel = 3, .closed_is_low = true};
  calibration.feet[back_right] = FootContact{.channel = 5, .closed_is_low = false};
  Pose in_the_air{};
  in_the_air.fill(20);
  const auto levels = [](bool third, bool fifth) {
    return [=](std::int32_t channel) { return channel == 3 ? third : fifth; };
  };
  EXPECT_EQ(feet_down(calibration, in_the_air, levels(false, true)), 0b1001U);
  EXPECT_EQ(feet_down(calibration, in_the_air, levels(true, false)), 0U);
  EXPECT_THAT(contact_channels(calibration), testing::ElementsAre(3, 5));
}

}  // namespace
}  // namespace lamprey::robot_bridge::drivers
