#include "robot_bridge/drivers/registry.hpp"

#include "robot_bridge/drivers/dynamixel_driver.hpp"
#include "robot_bridge/drivers/mock_driver.hpp"
#include "robot_bridge/drivers/ssc32_driver.hpp"

#include <gtest/gtest.h>

namespace lamprey::robot_bridge {
namespace {

TEST(DriverRegistry, MakesTheDriverOfEachFamily) {
  Calibration calibration = mock_calibration();
  EXPECT_NE(dynamic_cast<drivers::MockDriver*>(make_driver(calibration, "").get()), nullptr);
  calibration.family = DeviceFamily::ssc32;
  EXPECT_NE(dynamic_cast<drivers::Ssc32Driver*>(make_driver(calibration, "/dev/ttyUSB0").get()), nullptr);
  calibration.family = DeviceFamily::dynamixel;
  EXPECT_NE(dynamic_cast<drivers::DynamixelDriver*>(make_driver(calibration, "/dev/ttyUSB0").get()), nullptr);
}

}  // namespace
}  // namespace lamprey::robot_bridge
