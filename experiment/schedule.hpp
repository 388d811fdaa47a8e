#pragma once

#include "experiment/typed_value.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace lamprey::experiment {

/// What changes when a cycle begins: it and all later ones are tried under the new values, until they change again.
struct EnvironmentChange {
  std::uint32_t cycle = 0;                            ///< 1 to maximum_change_cycle; cycles are numbered from 0
  std::vector<std::pair<std::size_t, Value>> values;  ///< row of the registry and value; at least one, sorted by row

  bool operator==(const EnvironmentChange&) const = default;
};

/// Changes of the environment in a run (1.2), in ascending order of their cycles. Empty: it never changes.
using Schedule = std::vector<EnvironmentChange>;

inline constexpr std::uint32_t maximum_change_cycle = 10'000'000;
inline constexpr std::size_t maximum_changes = 1000;

/// Rows that a schedule may change: the weights of the fitness and the terrain. In the registry's order. Thread-safe.
std::span<const std::size_t> environment_rows();

/// Reads `500 required_distance=25 push_factor=0.5; 1000 required_stability=100`: changes with semicolons between
/// them, each a cycle and settings with white space between them. Values are bound as the registry's rows say.
/// Thread-safe, as are all functions here.
std::variant<Schedule, Refusal> checked_schedule(std::string_view text);

/// The same; throws InvalidInput.
Schedule parse_schedule(std::string_view text);

/// The one text of a schedule, which parse_schedule reads back: settings in the registry's order with one blank before
/// each, changes with "; " between them. Empty for the empty schedule.
std::string schedule_text(const Schedule& schedule);

// What reading a schedule from parts that have a place of their own needs.

/// The row, or why a schedule cannot change a parameter of that name.
std::variant<std::size_t, Refusal> changeable_row(std::string_view name);

/// The cycle of a change, or why the value is none.
std::variant<std::uint32_t, Refusal> change_cycle(const idl::Value& value);

/// Puts the values of a change into the registry's order.
void sort_values(EnvironmentChange& change);

}  // namespace lamprey::experiment
