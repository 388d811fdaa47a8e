#include "robot_bridge/drivers/registry.hpp"

#include "robot_bridge/drivers/dynamixel_driver.hpp"
#include "robot_bridge/drivers/mock_driver.hpp"
#include "robot_bridge/drivers/ssc32_driver.hpp"

#include <array>
#include <stdexcept>

namespace lamprey::robot_bridge {

namespace {

using Maker = std::unique_ptr<Driver> (*)(const Calibration&, const std::string& port);

struct Row {
  DeviceFamily family;
  Maker make;
};

constexpr std::array<Row, 3> rows = {{
    {DeviceFamily::mock,
     [](const Calibration& calibration, const std::string&) -> std::unique_ptr<Driver> {
       return std::make_unique<drivers::MockDriver>(calibration);
     }},
    {DeviceFamily::ssc32,
     [](const Calibration& calibration, const std::string& port) -> std::unique_ptr<Driver> {
       return std::make_unique<drivers::Ssc32Driver>(calibration, port);
     }},
    {DeviceFamily::dynamixel,
     [](const Calibration& calibration, const std::string& port) -> std::unique_ptr<Driver> {
       return std::make_unique<drivers::DynamixelDriver>(calibration, port);
     }},
}};

}  // namespace

std::unique_ptr<Driver> make_driver(const Calibration& calibration, const std::string& port) {
  for (const auto& row : rows) {
    if (row.family == calibration.family) return row.make(calibration, port);
  }
  throw std::invalid_argument("no driver '" + std::string(to_text(calibration.family)) + "'");
}

}  // namespace lamprey::robot_bridge
