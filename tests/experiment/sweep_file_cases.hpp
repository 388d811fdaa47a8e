#pragma once

#include <string_view>
#include <vector>

namespace lamprey::experiment {

/// A wrong sweep file and all that is said about it. docs/formats/sweep_file.md shows each of them.
struct WrongSweepFile {
  std::string_view title;
  std::string_view yaml;
  std::string_view messages;
};

const std::vector<WrongSweepFile>& wrong_sweep_files();

}  // namespace lamprey::experiment
