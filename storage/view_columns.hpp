#pragma once

#include "storage/schema.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace lamprey::storage {

/// FROM clause of the views over jobs: `j` is job, `s` is sweep.
inline constexpr std::string_view jobs_with_sweep = "FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep";

/// The column that shows a registered parameter: text, whole or real number; NULL where it doesn't apply.
/// Throws std::out_of_range for an unknown name.
Column parameter_column(std::string_view parameter);

/// Views that average the jobs of published figures, and the like by any other grouping.
std::vector<SchemaObject> figure_views();

}  // namespace lamprey::storage
