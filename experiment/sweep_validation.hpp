#pragma once

#include "experiment/sweep.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::experiment {

inline constexpr std::size_t maximum_name_length = 100;
inline constexpr std::size_t maximum_description_bytes = 10'000;
inline constexpr std::uint32_t maximum_replicates = 1'000'000;
inline constexpr int maximum_grids = 1000;
/// All axes of a sweep together hold at most this many values, so that their memory is bounded before it is taken.
inline constexpr std::uint64_t maximum_axis_values = 100'000;

/// Why a sweep cannot be called that; nothing if it can. For sweep files and for renaming alike.
std::optional<std::string> sweep_name_fault(const std::string& name);

/// Paths of fields, as in Problem::field. Names from outside are made printable.
std::string base_path(std::string_view parameter);
std::string grid_path(std::size_t grid);
std::string axis_path(const std::string& grid_path, std::string_view parameter);
std::string value_path(const std::string& axis_path, std::size_t value);

/// What is said about a name that no parameter has.
std::string unknown_parameter(std::string_view name);

/// What whoever read a specification knows about it.
struct ReadBefore {
  std::vector<Problem> problems;        ///< found while reading: about fields that could not be read
  std::vector<std::string> grid_paths;  ///< of the specification's grids in what was read; empty: as they are numbered
};

/// validate() after that: each field is checked, and what it takes several fields to see wherever all of them are in
/// order.
std::vector<Problem> validate(const idl::SweepSpecification& specification, ReadBefore before);

}  // namespace lamprey::experiment
