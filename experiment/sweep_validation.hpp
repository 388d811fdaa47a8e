#pragma once

#include "experiment/sweep.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace lamprey::experiment {

inline constexpr std::size_t maximum_name_length = 100;
inline constexpr std::size_t maximum_description_bytes = 10'000;
inline constexpr std::uint32_t maximum_replicates = 1'000'000;
inline constexpr int maximum_grids = 100;

/// Paths of fields, as in Problem::field. Names from outside are made printable.
std::string base_path(std::string_view parameter);
std::string grid_path(std::size_t grid);
std::string axis_path(std::size_t grid, std::string_view parameter);
std::string value_path(const std::string& axis_path, std::size_t value);

/// validate() after `found` has been found while the specification was read: each field is checked, and what it takes
/// several fields to see wherever all of them are in order.
std::vector<Problem> validate(const idl::SweepSpecification& specification, std::vector<Problem> found);

}  // namespace lamprey::experiment
