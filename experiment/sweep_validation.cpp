#include "experiment/sweep_validation.hpp"

#include "experiment/sweep_grid.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace lamprey::experiment {

namespace {

/// The values that each parameter takes in one grid, by registry row: those of its axis, else the one of the base,
/// else the default. A grid is the Cartesian product of them.
struct GridValues {
  std::vector<std::vector<Value>> values;
  std::vector<bool> is_axis;
};

std::string setting_text(const Parameter& parameter, const Value& value) {
  return std::string(parameter.name) + " " + to_text(value);
}

std::string condition_text(const Parameter& parameter) {
  std::string text = "it applies";
  const char* joint = " ";
  for (const auto& condition : parameter.applies_when) {
    text += joint + std::string(condition.is ? "where " : "unless ") + std::string(condition.parameter) + " is " +
            std::string(condition.value);
    joint = " and ";
  }
  return text;
}

// ---- single fields

void check_heading(const idl::SweepSpecification& specification, Findings& findings) {
  const auto& name = specification.name();
  const bool readable = std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  });
  const std::string takes =
      "a name has 1 to " + std::to_string(maximum_name_length) + " letters, digits, '-', '_' and '.'";
  if (name.empty()) {
    findings.add("name", "no name is given: " + takes);
  } else if (!readable || name.size() > maximum_name_length) {
    findings.add("name", "'" + printable(name) + "' is not allowed: " + takes);
  } else if (id128_from_hex(name)) {
    findings.add("name", "'" + name + "' reads like a sweep's id; choose a name that is not 32 hex digits");
  }
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

std::string unknown_parameter(std::string_view name) {
  std::vector<std::string_view> known;
  for (const auto& parameter : registry()) known.push_back(parameter.name);
  std::string message = "unknown parameter '" + printable(name) + "'";
  if (const auto nearest = nearest_name(name, known); !nearest.empty())
    return message + "; did you mean '" + nearest + "'?";
  message += "; known are";
  const char* joint = " ";
  for (const auto candidate : known) {
    message.append(joint).append(candidate);
    joint = ", ";
  }
  return message;
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
  if (parameter.kind == ParameterKind::choice) {
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
  GridValues grid;
  for (const auto& parameter : registry()) grid.values.push_back({parameter.default_value});
  for (const auto& [row, value] : base) grid.values[row] = {value};
  grid.is_axis.resize(registry().size());
  return grid;
}

GridValues check_grid(const idl::Grid& grid, std::size_t number, const std::map<std::size_t, Value>& base,
                      std::uint64_t& room, Findings& findings) {
  GridValues result = defaults_and(base);
  if (grid.axes().empty()) findings.add(grid_path(number), "has no axes; leave it out, or give it at least one");
  for (const auto& axis : grid.axes()) {
    if (findings.full()) break;
    const std::string path = axis_path(number, axis.parameter());
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

// ---- what it takes several fields to see

bool holds(const Condition& condition, const Value& value) {
  return (std::get<std::string>(value) == condition.value) == condition.is;
}

/// A value of the grid under which the parameter does not apply, with its row; nothing if it applies in every cell.
std::optional<std::pair<std::size_t, Value>> where_not_applying(const Parameter& parameter, const GridValues& grid) {
  for (const auto& condition : parameter.applies_when) {
    const std::size_t row = parameter_index(condition.parameter);
    for (const auto& value : grid.values[row]) {
      if (!holds(condition, value)) return std::pair{row, value};
    }
  }
  return std::nullopt;
}

/// Whether the parameter applies in any cell: its axes are independent, so each parameter that it depends on must
/// have a value for which all conditions on that parameter hold.
bool applies_somewhere(const Parameter& parameter, const GridValues& grid) {
  return std::ranges::all_of(parameter.applies_when, [&](const Condition& condition) {
    return std::ranges::any_of(grid.values[parameter_index(condition.parameter)], [&](const Value& value) {
      return std::ranges::all_of(parameter.applies_when, [&](const Condition& other) {
        return other.parameter != condition.parameter || holds(other, value);
      });
    });
  });
}

void check_axes_apply(const GridValues& grid, std::size_t number, Findings& findings) {
  for (std::size_t row = 0; row < registry().size(); ++row) {
    const Parameter& parameter = registry()[row];
    if (!grid.is_axis[row]) continue;
    const std::string path = axis_path(number, parameter.name);
    const auto exception = where_not_applying(parameter, grid);
    if (!exception) continue;
    const std::string where = setting_text(registry()[exception->first], exception->second);
    if (!applies_somewhere(parameter, grid)) {
      findings.add(path, "applies nowhere in this grid, which has " + where + ": " + condition_text(parameter));
    } else if (grid.values[row].size() > 1) {
      findings.add(path, "would repeat jobs, since it does not apply to " + where + ": " + condition_text(parameter) +
                             "; give " + where + " a grid of its own");
    }
  }
}

using ValuePair = std::pair<Value, Value>;

/// A rule between two parameters: finds, among the sorted values that each takes, a pair that is refused.
struct Contradiction {
  std::string_view first;
  std::string_view second;
  std::optional<ValuePair> (*find)(const std::vector<Value>&, const std::vector<Value>&);
  std::string_view reason;
};

/// The one place for rules between parameters.
constexpr Contradiction contradictions[] = {
    {"step_variance", "objective",
     [](const std::vector<Value>& variances, const std::vector<Value>& objectives) -> std::optional<ValuePair> {
       const ValuePair refused{"root_error", "maximise"};
       if (!std::ranges::binary_search(variances, refused.first)) return std::nullopt;
       if (!std::ranges::binary_search(objectives, refused.second)) return std::nullopt;
       return refused;
     },
     "the root of the error needs a target: under maximise the error is minus the fitness"},
    {"minimum_standard_deviation", "maximum_standard_deviation",
     [](const std::vector<Value>& minima, const std::vector<Value>& maxima) -> std::optional<ValuePair> {
       if (minima.back() <= maxima.front()) return std::nullopt;
       return ValuePair{minima.back(), maxima.front()};
     },
     "the minimum must not be above the maximum"},
};

void check_contradictions(const GridValues& grid, std::size_t number, Findings& findings) {
  for (const auto& rule : contradictions) {
    const std::size_t first = parameter_index(rule.first);
    const std::size_t second = parameter_index(rule.second);
    if (!applies_somewhere(registry()[first], grid) || !applies_somewhere(registry()[second], grid)) continue;
    const auto refused = rule.find(grid.values[first], grid.values[second]);
    if (!refused) continue;
    const std::string path = grid.is_axis[first]    ? axis_path(number, rule.first)
                             : grid.is_axis[second] ? axis_path(number, rule.second)
                                                    : base_path(rule.first);
    findings.add(path, setting_text(registry()[first], refused->first) + " contradicts " +
                           setting_text(registry()[second], refused->second) + ": " + std::string(rule.reason));
  }
}

void check_base_applies(const idl::SweepSpecification& specification, const std::vector<GridValues>& grids,
                        Findings& findings) {
  for (const auto& setting : specification.base()) {
    const Parameter& parameter = *find_parameter(setting.parameter());
    const bool applies =
        std::ranges::any_of(grids, [&](const GridValues& grid) { return applies_somewhere(parameter, grid); });
    if (!applies) {
      findings.add(base_path(parameter.name), "applies to no job of this sweep: " + condition_text(parameter));
    }
  }
}

/// Rows that other parameters' conditions ask for. They always apply themselves (the registry's test says so).
const std::vector<std::size_t>& condition_rows() {
  static const std::vector<std::size_t> rows = [] {
    std::set<std::size_t> found;
    for (const auto& parameter : registry()) {
      for (const auto& condition : parameter.applies_when) found.insert(parameter_index(condition.parameter));
    }
    return std::vector<std::size_t>(found.begin(), found.end());
  }();
  return rows;
}

/// The values that both sorted lists have.
std::vector<Value> common_values(const std::vector<Value>& a, const std::vector<Value>& b) {
  std::vector<Value> common;
  std::ranges::set_intersection(a, b, std::back_inserter(common));
  return common;
}

/// A job that two grids (with sorted values) both have, or nothing.
/// Two cells are the same job if the same parameters apply and have the same values. Which apply is decided by the few
/// parameters that conditions ask for, so it suffices to try those of their values that both grids have; every other
/// parameter either does not apply then or needs one common value.
class CommonJob {
 public:
  CommonJob(const GridValues& a, const GridValues& b) {
    for (std::size_t row = 0; row < registry().size(); ++row)
      common_.push_back(common_values(a.values[row], b.values[row]));
  }

  std::optional<Parameters> find() { return find_from(0) ? std::optional(job_) : std::nullopt; }

 private:
  bool find_from(std::size_t condition) {
    if (condition == condition_rows().size()) return completes();
    const std::size_t row = condition_rows()[condition];
    return std::ranges::any_of(common_[row], [&](const Value& value) {
      job_.set(row, value);
      return find_from(condition + 1);
    });
  }

  bool completes() {
    for (std::size_t row = 0; row < registry().size(); ++row) {
      if (std::ranges::binary_search(condition_rows(), row) || !job_.applies(row)) continue;
      if (common_[row].empty()) return false;
      job_.set(row, common_[row].front());
    }
    return true;
  }

  std::vector<std::vector<Value>> common_;
  Parameters job_;
};

void check_overlap(const std::vector<GridValues>& grids, std::size_t a, std::size_t b, Findings& findings) {
  const auto job = CommonJob(grids[a], grids[b]).find();
  if (!job) return;
  std::string cell;
  for (std::size_t row = 0; row < registry().size(); ++row) {
    if ((!grids[a].is_axis[row] && !grids[b].is_axis[row]) || !job->applies(row)) continue;
    cell += (cell.empty() ? "" : ", ") + setting_text(registry()[row], (*job)[row]);
  }
  findings.add(grid_path(b),
               "has jobs that " + grid_path(a) + " has too (such as " + cell + "); a sweep runs each job once");
}

void check_job_count(const std::vector<GridValues>& grids, std::uint64_t replicates, Findings& findings) {
  bool huge = false;
  const auto times = [&](std::uint64_t a, std::uint64_t b) {
    std::uint64_t product = 0;
    huge = __builtin_mul_overflow(a, b, &product) || huge;
    return product;
  };
  std::uint64_t cells = 0;
  for (const auto& grid : grids) {
    const std::uint64_t product =
        std::accumulate(grid.values.begin(), grid.values.end(), std::uint64_t{1},
                        [&](std::uint64_t sum, const auto& v) { return times(sum, v.size()); });
    huge = __builtin_add_overflow(cells, product, &cells) || huge;
  }
  const bool too_many_cells = huge || cells > maximum_jobs;
  const std::uint64_t jobs = times(cells, replicates);
  if (!huge && jobs <= maximum_jobs) return;
  findings.add(too_many_cells ? "grids" : "replicates",
               "the sweep would have " + (huge ? "more than 10^19" : std::to_string(jobs)) + " jobs; at most " +
                   std::to_string(maximum_jobs) + " are allowed");
}

void check_together(const idl::SweepSpecification& specification, std::vector<GridValues> grids, Findings& findings) {
  std::vector<std::size_t> sound;
  for (std::size_t i = 0; i < grids.size(); ++i) {
    if (!findings.any_within(grid_path(i))) sound.push_back(i);
    for (auto& values : grids[i].values) std::ranges::sort(values);
  }
  const bool all_sound = !findings.any_within("grids");
  for (const std::size_t i : sound) {
    check_axes_apply(grids[i], i, findings);
    check_contradictions(grids[i], i, findings);
  }
  for (std::size_t i = 1; i < sound.size(); ++i) {
    for (std::size_t j = 0; j < i && !findings.full(); ++j) check_overlap(grids, sound[j], sound[i], findings);
  }
  if (!all_sound) return;
  check_base_applies(specification, grids, findings);
  if (!findings.any_within("replicates")) check_job_count(grids, specification.replicates(), findings);
}

}  // namespace

std::string base_path(std::string_view parameter) {
  return "base." + printable(parameter);
}
std::string grid_path(std::size_t grid) {
  return "grids[" + std::to_string(grid) + "]";
}
std::string axis_path(std::size_t grid, std::string_view parameter) {
  return grid_path(grid) + "." + printable(parameter);
}
std::string value_path(const std::string& axis_path, std::size_t value) {
  return axis_path + "[" + std::to_string(value) + "]";
}

std::vector<Problem> validate(const idl::SweepSpecification& specification, std::vector<Problem> found) {
  Findings findings(std::move(found));
  check_heading(specification, findings);
  const auto base = check_base(specification, findings);
  if (specification.grids_size() > maximum_grids) {
    findings.add("grids", "has " + std::to_string(specification.grids_size()) + " grids; at most " +
                              std::to_string(maximum_grids) + " are allowed");
    return findings.take();
  }
  std::vector<GridValues> grids;
  std::uint64_t room = maximum_axis_values;
  for (const auto& grid : specification.grids()) {
    grids.push_back(check_grid(grid, grids.size(), base, room, findings));
  }
  if (grids.empty()) grids.push_back(defaults_and(base));
  // A wrong value of the base is wrong in every grid: nothing can be said about cells then. Nor where checking stopped
  // early, since axes are incomplete.
  if (!findings.full() && !findings.any_within("base")) check_together(specification, std::move(grids), findings);
  return findings.take();
}

std::vector<Problem> validate(const idl::SweepSpecification& specification) {
  return validate(specification, {});
}

}  // namespace lamprey::experiment
