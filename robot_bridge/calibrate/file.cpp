#include "robot_bridge/calibrate/file.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace lamprey::robot_bridge::calibrate {

void write_calibration(const Calibration& calibration, const std::string& path) {
  const std::string text = to_yaml(calibration);
  parse_calibration(text, path);
  const std::string next = path + ".next";
  std::ofstream file(next, std::ios::trunc);
  file << text << std::flush;
  if (!file) throw std::runtime_error("'" + next + "' can't be written");
  file.close();
  if (std::filesystem::exists(path)) {
    std::filesystem::copy_file(path, path + ".before", std::filesystem::copy_options::overwrite_existing);
  }
  std::filesystem::rename(next, path);
}

}  // namespace lamprey::robot_bridge::calibrate
