#include "storage/results_store.hpp"

#include <array>
#include <string>

namespace lamprey::storage {

std::string to_text(SweepState state) {
  constexpr std::array<const char*, 6> names = {"running", "paused", "finished", "cancelling", "cancelled", "deleting"};
  return names.at(static_cast<std::size_t>(state));
}

std::string to_text(JobState state) {
  constexpr std::array<const char*, 4> names = {"done", "failed", "quarantined", "cancelled"};
  return names.at(static_cast<std::size_t>(state));
}

}  // namespace lamprey::storage
