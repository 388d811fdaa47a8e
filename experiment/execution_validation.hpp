#pragma once

#include "experiment/problem.hpp"
#include "idl/sweep.pb.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// How a sweep is run (idl::Execution): what its fields may hold, for sweep files, command lines and the network alike.
/// Free functions; any thread.
namespace lamprey::experiment {

inline constexpr std::int32_t minimum_priority = -1000;
inline constexpr std::int32_t maximum_priority = 1000;
inline constexpr std::uint32_t maximum_concurrent_jobs = 100'000'000;
inline constexpr double maximum_time_limit = 31'536'000;  ///< seconds: a year
inline constexpr std::uint32_t maximum_attempts = 100;
inline constexpr int maximum_labels = 16;
inline constexpr std::size_t maximum_label_length = 64;

/// What each field takes, for messages: "a whole number from -1000 to 1000".
std::string priority_takes();
std::string max_concurrent_takes();
std::string time_limit_takes();
std::string attempts_takes();

/// The measures that can end a sweep: counts of jobs, and the scores of the view `result`.
const std::vector<std::string_view>& stop_measures();

/// "a whole number from 1 to 100000000", "a number": what such a measure is compared with.
std::string stop_measure_takes(std::string_view measure);

/// Why the text is no label that a worker can have, or no tag (`what`: "label" or "tag"); nothing if it is one.
std::optional<std::string> label_fault(std::string_view text, std::string_view what);

/// Adds what is wrong, each under the name that the field has in a sweep file: priority, stop_when.failed, needs[0].
void check_execution(const idl::Execution& execution, Findings& findings);

/// The same, collected; empty if all is right.
std::vector<Problem> validate(const idl::Execution& execution);

}  // namespace lamprey::experiment
