#include "robot_bridge/calibrate/file.hpp"

#include "experiment/problem.hpp"
#include "robot_bridge/calibrate/session.hpp"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace lamprey::robot_bridge::calibrate {
namespace {

class CalibrationFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "lamprey-calibrate-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::filesystem::path folder;
  Calibration calibration = first_draft(DeviceFamily::ssc32, 115200);
};

TEST_F(CalibrationFile, IsReadBackTheSame) {
  const std::string path = folder / "robot.yaml";
  write_calibration(calibration, path);
  EXPECT_EQ(read_calibration(path), calibration);
  EXPECT_FALSE(std::filesystem::exists(path + ".before"));
}

TEST_F(CalibrationFile, KeepsTheOneBefore) {
  const std::string path = folder / "robot.yaml";
  write_calibration(calibration, path);
  Calibration changed = calibration;
  changed.joints[3].minimum += 7;
  write_calibration(changed, path);
  EXPECT_EQ(read_calibration(path), changed);
  EXPECT_EQ(read_calibration(path + ".before"), calibration);
}

TEST_F(CalibrationFile, WhatABridgeWouldRefuseIsNotWritten) {
  const std::string path = folder / "robot.yaml";
  write_calibration(calibration, path);
  Calibration wrong = calibration;
  wrong.joints[0].minimum = wrong.joints[0].maximum;
  EXPECT_THROW(write_calibration(wrong, path), experiment::InvalidInput);
  EXPECT_EQ(read_calibration(path), calibration);
}

TEST_F(CalibrationFile, AFolderThatIsNotThereIsAnError) {
  EXPECT_THROW(write_calibration(calibration, folder / "none" / "robot.yaml"), std::runtime_error);
}

}  // namespace
}  // namespace lamprey::robot_bridge::calibrate
