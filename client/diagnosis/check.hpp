#pragma once

#include <string>

namespace lamprey::client::diagnosis {

/// What one look has shown, and what to do about it.
struct Check {
  enum class Level : unsigned char {
    good,
    notable,  ///< works, but may surprise
    trouble,  ///< programs won't meet, or not as they should
  };
  Level level = Level::good;
  std::string subject;  ///< "multicast"
  std::string finding;  ///< a sentence without its full stop
  std::string advice;   ///< sentences; empty where there is nothing to do
  bool operator==(const Check&) const = default;
};

}  // namespace lamprey::client::diagnosis
