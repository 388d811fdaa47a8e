#include "client/output/bar.hpp"

#include <algorithm>

namespace lamprey::client::output {

namespace {

std::string repeated(std::string_view text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

/// Rounded down, but not to nothing.
std::size_t share_of(std::uint64_t part, std::uint64_t whole, std::size_t columns) {
  if (part == 0 || whole == 0) return 0;
  const double share = static_cast<double>(part) / static_cast<double>(whole);
  return std::clamp<std::size_t>(static_cast<std::size_t>(share * static_cast<double>(columns)), 1, columns);
}

}  // namespace

std::string bar(const Console& console, const BarParts& parts, std::size_t columns) {
  const std::uint64_t ended = std::min(parts.good + parts.bad, parts.jobs);
  const bool complete = ended == parts.jobs;
  const std::size_t room = complete ? columns : columns - std::min<std::size_t>(columns, 1);
  const std::size_t filled = complete ? columns : std::min(share_of(ended, parts.jobs, columns), room);
  const std::size_t bad =
      parts.good == 0 && parts.bad > 0 ? filled : std::min(share_of(parts.bad, parts.jobs, columns), filled);
  return console.good(repeated(console.unicode ? "█" : "#", filled - bad)) +
         console.alert(repeated(console.unicode ? "▒" : "!", bad)) +
         console.dim(repeated(console.unicode ? "░" : ".", columns - filled));
}

}  // namespace lamprey::client::output
