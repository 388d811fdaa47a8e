#pragma once

#include "client/output/console.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace lamprey::client::output {

/// Lines on a terminal that are rewritten in place; what is above them stays, and the last ones stay at the end. One
/// thread.
class LiveScreen {
 public:
  explicit LiveScreen(const Console& console) : console_(console) {}

  /// In the place of the lines drawn before. Longer lines are cut; lines beyond the terminal's height are left out.
  void draw(const std::vector<std::string>& lines, TerminalSize size);

 private:
  const Console& console_;
  std::size_t drawn_ = 0;
};

}  // namespace lamprey::client::output
