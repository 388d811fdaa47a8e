#pragma once

#include "client/output/console.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace lamprey::client::output {

/// Of `jobs`; the rest has not ended.
struct BarParts {
  std::uint64_t jobs = 0;
  std::uint64_t good = 0;
  std::uint64_t bad = 0;
};

/// "████████▒░░░░░░░": good, bad and missing parts in so many columns. A part that is not empty shows, as long as there
/// is room, and the bar is full only if nothing is missing.
std::string bar(const Console& console, const BarParts& parts, std::size_t columns);

}  // namespace lamprey::client::output
