#include "experiment/sweep_validation.hpp"

#include "experiment/execution_validation.hpp"
#include "experiment/sweep_cells.hpp"
#include "experiment/typed_value.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace lamprey::experiment {

namespace {

void check_heading(const idl::SweepSpecification& specification, Findings& findings) {
  if (auto fault = sweep_name_fault(specification.name())) findings.add("name", std::move(*fault));
  if (specification.description().size() > maximum_description_bytes) {
    findings.add("description", "has " + std::to_string(specification.description().size()) + " bytes; at most " +
                                    std::to_string(maximum_description_bytes) + " are allowed");
  } else if (first_unreadable(specification.description()) != std::string::npos) {
    findings.add("description",
                 "'" + printable(specification.description()) + "' is not text in UTF-8, or has control characters");
  }
  if (specification.replicates() < 1 || specification.replicates() > maximum_replicates) {
    findings.add("replicates", std::to_string(specification.replicates()) +
                                   " is out of range: replicates takes a whole number from 1 to " +
                                   std::to_string(maximum_replicates));
  }
}

/// The base's values by row.
std::map<std::size_t, Value> check_base(const idl::SweepSpecification& specification, Findings& findings) {
  std::map<std::size_t, Value> values;
  std::set<std::size_t> seen;
  for (const auto& setting : specification.base()) {
    if (findings.full()) break;
    const std::string path = base_path(setting.parameter());
    const Parameter* parameter = find_parameter(setting.parameter());
    if (parameter == nullptr) {
      findings.add(path, unknown_parameter(setting.parameter()));
      continue;
    }
    const std::size_t row = parameter_index(parameter->name);
    if (!seen.insert(row).second) {
      findings.add(path, "is set twice; keep one of them");
      continue;
    }
    const TypedValue typed = typed_value(*parameter, setting.value());
    if (const auto* value = std::get_if<Value>(&typed)) {
      values.emplace(row, *value);
    } else {
      findings.add(path, std::get<Refusal>(typed).reason);
    }
  }
  return values;
}

/// A part of a range that has been typed, or nothing after its problem has been noted.
std::optional<Value> checked(const TypedValue& typed, const std::string& path, Findings& findings) {
  if (const auto* value = std::get_if<Value>(&typed)) return *value;
  findings.add(path, std::get<Refusal>(typed).reason);
  return std::nullopt;
}

/// The values of a range, or none after its problems have been noted. `room`: how many more values the sweep may have.
std::vector<Value> check_range(const Parameter& parameter, const idl::Range& range, const std::string& path,
                               std::uint64_t room, Findings& findings) {
  if (!is_number(parameter.kind)) {
    findings.add(path, "a range needs numbers: " + std::string(parameter.name) + " takes " + allowed_values(parameter));
    return {};
  }
  const auto from = checked(typed_value(parameter, range.from()), path + ".from", findings);
  const auto to = checked(typed_value(parameter, range.to()), path + ".to", findings);
  const auto step = checked(typed_step(parameter, range.step()), path + ".step", findings);
  if (!from || !to || !step) return {};
  if (*from > *to) {
    findings.add(path,
                 "the range goes from " + to_text(*from) + " down to " + to_text(*to) + "; from must not be above to");
    return {};
  }
  const std::uint64_t size = range_size({*from, *to, *step});
  if (size > room) {
    findings.add(path, "the range has too many values: the axes of a sweep hold at most " +
                           std::to_string(maximum_axis_values) + " values together");
    return {};
  }
  return range_values({*from, *to, *step});
}

std::vector<Value> check_list(const Parameter& parameter, const idl::Axis& axis, const std::string& path,
                              std::uint64_t room, Findings& findings) {
  if (static_cast<std::uint64_t>(axis.values_size()) > room) {
    findings.add(path, "the list has too many values: the axes of a sweep hold at most " +
                           std::to_string(maximum_axis_values) + " values together");
    return {};
  }
  std::vector<Value> values;
  for (int i = 0; i < axis.values_size() && !findings.full(); ++i) {
    const auto value =
        checked(typed_value(parameter, axis.values(i)), value_path(path, static_cast<std::size_t>(i)), findings);
    if (value) values.push_back(*value);
  }
  return values;
}

/// The values of the axis; incomplete only if a problem has been noted.
std::vector<Value> check_axis(const Parameter& parameter, const idl::Axis& axis, const std::string& path,
                              std::uint64_t room, Findings& findings) {
  if (axis.has_range() && axis.values_size() > 0) {
    findings.add(path, "has both values and a range; keep one of them");
    return {};
  }
  auto values = axis.has_range() ? check_range(parameter, axis.range(), path, room, findings)
                                 : check_list(parameter, axis, path, room, findings);
  if (!axis.has_range() && axis.values_size() == 0) {
    findings.add(path, "has no values: " + std::string(parameter.name) + " takes " + allowed_values(parameter));
  }
  std::map<Value, std::size_t> first_use;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto [first, is_new] = first_use.emplace(values[i], i);
    if (is_new) continue;
    const std::string where = axis.has_range() ? path : value_path(path, i);
    findings.add(where, axis.has_range() ? "the step is too small to tell its values apart"
                                         : to_text(values[i]) + " is in this axis twice");
  }
  return values;
}

GridValues defaults_and(const std::map<std::size_t, Value>& base) {
  GridValues grid{.path = grid_path(0), .values = {}, .is_axis = {}};
  for (const auto& parameter : registry()) grid.values.push_back({parameter.default_value});
  for (const auto& [row, value] : base) grid.values[row] = {value};
  grid.is_axis.resize(registry().size());
  return grid;
}

GridValues check_grid(const idl::Grid& grid, const std::string& grid_path, const std::map<std::size_t, Value>& base,
                      std::uint64_t& room, Findings& findings) {
  GridValues result = defaults_and(base);
  result.path = grid_path;
  if (grid.axes().empty()) findings.add(grid_path, "has no axes; leave it out, or give it at least one");
  for (const auto& axis : grid.axes()) {
    if (findings.full()) break;
    const std::string path = axis_path(grid_path, axis.parameter());
    const Parameter* parameter = find_parameter(axis.parameter());
    if (parameter == nullptr) {
      findings.add(path, unknown_parameter(axis.parameter()));
      continue;
    }
    const std::size_t row = parameter_index(parameter->name);
    if (result.is_axis[row]) findings.add(path, "is an axis of this grid twice; keep one of them");
    if (base.contains(row)) findings.add(path, "is set in base too; keep one of them");
    result.is_axis[row] = true;
    result.values[row] = check_axis(*parameter, axis, path, room, findings);
    room -= result.values[row].size();
  }
  return result;
}

}  // namespace

std::optional<std::string> sweep_name_fault(const std::string& name) {
  const bool readable = std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  });
  const std::string takes =
      "a name has 1 to " + std::to_string(maximum_name_length) + " letters, digits, '-', '_' and '.'";
  if (name.empty()) return "no name is given: " + takes;
  if (!readable || name.size() > maximum_name_length) return "'" + printable(name) + "' is not allowed: " + takes;
  if (id128_from_hex(name)) return "'" + name + "' reads like a sweep's id; choose a name that is not 32 hex digits";
  return std::nullopt;
}

std::string base_path(std::string_view parameter) {
  return "base." + printable(parameter);
}
std::string grid_path(std::size_t grid) {
  return "grids[" + std::to_string(grid) + "]";
}
std::string axis_path(const std::string& grid_path, std::string_view parameter) {
  return grid_path + "." + printable(parameter);
}
std::string value_path(const std::string& axis_path, std::size_t value) {
  return axis_path + "[" + std::to_string(value) + "]";
}

std::string unknown_parameter(std::string_view name) {
  std::vector<std::string_view> known;
  for (const auto& parameter : registry()) known.push_back(parameter.name);
  const std::string message = "unknown parameter '" + printable(name) + "'";
  if (const auto nearest = nearest_name(name, known); !nearest.empty()) {
    return message + "; did you mean '" + nearest + "'?";
  }
  return message + "; `lamprey parameters` lists all";
}

std::vector<Problem> validate(const idl::SweepSpecification& specification, ReadBefore before) {
  Findings findings(std::move(before.problems));
  check_heading(specification, findings);
  check_execution(specification.execution(), findings);
  const auto base = check_base(specification, findings);
  if (specification.grids_size() > maximum_grids) {
    findings.add("grids", "has " + std::to_string(specification.grids_size()) + " grids; at most " +
                              std::to_string(maximum_grids) + " are allowed");
    return findings.take();
  }
  std::vector<GridValues> grids;
  std::uint64_t room = maximum_axis_values;
  for (const auto& grid : specification.grids()) {
    const std::size_t i = grids.size();
    grids.push_back(
        check_grid(grid, i < before.grid_paths.size() ? before.grid_paths[i] : grid_path(i), base, room, findings));
  }
  // Without grids the base is the only cell; but there may be grids that could not be read.
  if (grids.empty() && !findings.any_within("grids")) grids.push_back(defaults_and(base));
  // A wrong value of the base is wrong in every grid: nothing can be said about cells then. Nor where checking stopped
  // early, since axes are incomplete.
  if (!findings.full() && !findings.any_within("base")) check_together(specification, std::move(grids), findings);
  return findings.take();
}

std::vector<Problem> validate(const idl::SweepSpecification& specification) {
  return validate(specification, ReadBefore{});
}

}  // namespace lamprey::experiment
