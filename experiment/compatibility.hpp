#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace lamprey::experiment {

/// A rule between two choices: a job in which both apply, and `parameter` is one of `values`, must have `other` as one
/// of `allowed`. Rules that go both ways are two rows.
struct Compatibility {
  std::string_view parameter;
  std::vector<std::string_view> values;
  std::string_view other;
  std::vector<std::string_view> allowed;
  std::string_view reason;  ///< why, for the message
};

/// All rules between choices. Thread-safe; the rows live as long as the program.
std::span<const Compatibility> compatibilities();

}  // namespace lamprey::experiment
