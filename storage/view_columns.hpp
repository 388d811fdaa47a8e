#pragma once

#include "storage/schema.hpp"

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::storage {

/// FROM clause of the views over jobs: `j` is job, `s` is sweep.
inline constexpr std::string_view jobs_with_sweep = "FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep";

/// The column that shows a registered parameter: text, whole or real number; NULL where it doesn't apply.
/// Throws std::out_of_range for an unknown name.
Column parameter_column(std::string_view parameter);

/// JSON object of the parameters that are not among `shown`, to group by, so that no view ever averages jobs that
/// differ in anything but what it says, whatever parameters the registry will have.
Column other_parameters(std::span<const std::string_view> shown);

/// ` AND parameter = 'value'`, or ` AND parameter IN (…)`.
std::string only(std::string_view parameter, std::initializer_list<std::string_view> values);

/// FROM clause of the views over measures: `m` is a measure of `j`.
inline constexpr std::string_view measures_of_jobs = " JOIN json_each(j.measures) AS m";

/// A part of the measure whose JSON text is in `row`.
inline std::string measure_name(std::string_view row = "m") {
  return "json_extract(" + std::string(row) + ".value, '$[0]')";
}
inline std::string measure_index(std::string_view row = "m") {
  return "json_extract(" + std::string(row) + ".value, '$[1]')";
}
inline std::string measure_value(std::string_view row = "m") {
  return "json_extract(" + std::string(row) + ".value, '$[2]')";
}

/// The measure of that name, with the index that `m` has, of the same job; NULL if there is none.
std::string measure_beside(std::string_view name);

/// Views of what only some jobs tell: measure, recovery, gait_change, variation.
std::vector<SchemaObject> measure_views();

/// Views of what robots did, and of how far that is from simulation: recordings, motion, gap.
std::vector<SchemaObject> robot_views();

/// ` IN ('…', …)` of the values of the parameter `robot` that are no simulation.
std::string real_robots();

/// Unix time in milliseconds as ISO 8601.
std::string utc_time(const std::string& milliseconds);

/// The column `worker`: the key of that name in `row` as 16 hex digits.
Column worker_key(const std::string& row, const std::string& description);

/// Views of how sweeps are getting on and how it came about: progress, provenance, attempts, audits, history.
std::vector<SchemaObject> history_views();

/// Views that average the jobs of published figures, and the like by any other grouping.
std::vector<SchemaObject> figure_views();

}  // namespace lamprey::storage
