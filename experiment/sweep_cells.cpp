#include "experiment/sweep_cells.hpp"

#include "experiment/compatibility.hpp"
#include "experiment/schedule.hpp"
#include "experiment/sweep_validation.hpp"
#include "experiment/typed_value.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <span>

namespace lamprey::experiment {

namespace {

std::string joined(std::span<const std::string_view> names) {
  std::string text;
  for (const auto name : names) text.append(text.empty() ? "" : " or ").append(name);
  return text;
}

std::string condition_text(std::size_t row) {
  std::string text = "it applies";
  const char* joint = " ";
  for (const auto& condition : conditions_of(row)) {
    text += joint + std::string(condition.is ? "where " : "unless ") + std::string(registry()[condition.row].name) +
            " is " + joined(condition.values);
    joint = " and ";
  }
  return text;
}

bool contains(std::span<const std::string_view> names, const Value& value) {
  return std::ranges::find(names, std::get<std::string>(value)) != names.end();
}

// ---- which parameters apply

/// A value of the grid under which the parameter does not apply, with its row; nothing if it applies in every cell.
std::optional<std::pair<std::size_t, Value>> where_not_applying(std::size_t row, const GridValues& grid) {
  for (const auto& condition : conditions_of(row)) {
    for (const auto& value : grid.values[condition.row]) {
      if (!condition.holds(value)) return std::pair{condition.row, value};
    }
  }
  return std::nullopt;
}

/// Whether all conditions hold in any cell: axes are independent, so each parameter that they ask for must have a value
/// for which all conditions on that parameter hold.
bool hold_somewhere(std::span<const RowCondition> conditions, const GridValues& grid) {
  return std::ranges::all_of(conditions, [&](const RowCondition& condition) {
    return std::ranges::any_of(grid.values[condition.row], [&](const Value& value) {
      return std::ranges::all_of(
          conditions, [&](const RowCondition& other) { return other.row != condition.row || other.holds(value); });
    });
  });
}

bool applies_somewhere(std::size_t row, const GridValues& grid) {
  return hold_somewhere(conditions_of(row), grid);
}

std::vector<RowCondition> conditions_of_both(std::size_t a, std::size_t b) {
  const auto first = conditions_of(a);
  const auto second = conditions_of(b);
  std::vector<RowCondition> both(first.begin(), first.end());
  both.insert(both.end(), second.begin(), second.end());
  return both;
}

void check_axes_apply(const GridValues& grid, Findings& findings) {
  for (std::size_t row = 0; row < registry().size(); ++row) {
    if (!grid.is_axis[row]) continue;
    const std::string path = axis_path(grid.path, registry()[row].name);
    const auto exception = where_not_applying(row, grid);
    if (!exception) continue;
    const std::string where = setting_text(registry()[exception->first], exception->second);
    if (!applies_somewhere(row, grid)) {
      findings.add(path, "applies nowhere in this grid, which has " + where + ": " + condition_text(row));
    } else if (grid.values[row].size() > 1) {
      findings.add(path, "would repeat jobs, since it does not apply to " + where + ": " + condition_text(row) +
                             "; say `where` it does, or give " + where + " a grid of its own");
    }
  }
}

void check_base_applies(const idl::SweepSpecification& specification, const std::vector<GridValues>& grids,
                        Findings& findings) {
  for (const auto& setting : specification.base()) {
    const std::size_t row = parameter_index(setting.parameter());
    const bool applies =
        std::ranges::any_of(grids, [&](const GridValues& grid) { return applies_somewhere(row, grid); });
    if (!applies) {
      findings.add(base_path(setting.parameter()), "applies to no job of this sweep: " + condition_text(row));
    }
  }
}

// ---- which values go together

/// Where to look for a problem between two parameters of a grid.
std::string place_of_both(const GridValues& grid, std::string_view first, std::string_view second) {
  if (grid.is_axis[parameter_index(first)]) return axis_path(grid.path, first);
  if (grid.is_axis[parameter_index(second)]) return axis_path(grid.path, second);
  return base_path(first);
}

void note_contradiction(const GridValues& grid, const Parameter& first, const Value& value, const Parameter& second,
                        const Value& other, const std::string& reason, Findings& findings) {
  findings.add(place_of_both(grid, first.name, second.name),
               setting_text(first, value) + " contradicts " + setting_text(second, other) + ": " + reason);
}

/// Notes the first pair of values, both of which apply in a cell of the grid, that the rule refuses.
void check_compatibility(const Compatibility& rule, const GridValues& grid, Findings& findings) {
  const std::size_t first = parameter_index(rule.parameter);
  const std::size_t second = parameter_index(rule.other);
  const auto meet = [&](const Value& value, const Value& other) {
    auto conditions = conditions_of_both(first, second);
    conditions.push_back({first, true, {std::get<std::string>(value)}});
    conditions.push_back({second, true, {std::get<std::string>(other)}});
    return hold_somewhere(conditions, grid);
  };
  const auto is_allowed = [&](const Value& other) { return contains(rule.allowed, other); };
  for (const auto& value : grid.values[first]) {
    if (!contains(rule.values, value)) continue;
    for (const auto& other : grid.values[second]) {
      if (is_allowed(other) || !meet(value, other)) continue;
      const bool mixed =
          std::ranges::any_of(grid.values[second], is_allowed) ||
          !std::ranges::all_of(grid.values[first], [&](const Value& v) { return contains(rule.values, v); });
      const auto& parameter = registry()[first];
      return note_contradiction(grid, parameter, value, registry()[second], other,
                                std::string(rule.reason) + "; " + setting_text(parameter, value) + " goes with " +
                                    std::string(rule.other) + " " + joined(rule.allowed) +
                                    (mixed ? "; give what goes together a grid of its own" : ""),
                                findings);
    }
  }
}

/// Two numbers of which the first must not be above the second, where both apply and `where` holds.
struct Order {
  std::string_view smaller;
  std::string_view larger;
  std::string_view reason;
  std::optional<Condition> where = std::nullopt;
};

std::span<const Order> orders() {
  static const std::vector<Order> rows = {
      {"minimum_standard_deviation", "maximum_standard_deviation", "the minimum must not be above the maximum"},
      {"tournament_size", "population", "a tournament has different members of the population"},
      {"population", "offspring", "under mu_comma_lambda only children live on, so they must be as many as the parents",
       Condition{"strategy", true, {"mu_comma_lambda"}}}};
  return rows;
}

void check_order(const Order& rule, const GridValues& grid, Findings& findings) {
  const std::size_t smaller = parameter_index(rule.smaller);
  const std::size_t larger = parameter_index(rule.larger);
  std::vector<RowCondition> conditions = conditions_of_both(smaller, larger);
  if (rule.where) conditions.push_back({parameter_index(rule.where->parameter), rule.where->is, rule.where->values});
  if (!hold_somewhere(conditions, grid)) return;
  const Value& most = grid.values[smaller].back();
  const Value& least = grid.values[larger].front();
  if (most <= least) return;
  note_contradiction(grid, registry()[smaller], most, registry()[larger], least, std::string(rule.reason), findings);
}

/// Changes of the environment must happen while the job runs.
void check_changes(const GridValues& grid, Findings& findings) {
  const std::size_t environment = parameter_index("environment");
  const std::size_t cycles = parameter_index("cycles");
  if (!applies_somewhere(environment, grid)) return;
  const Value& fewest = grid.values[cycles].front();
  for (const auto& value : grid.values[environment]) {
    const Schedule schedule = parse_schedule(std::get<std::string>(value));
    if (schedule.empty() || schedule.back().cycle < std::get<std::int64_t>(fewest)) continue;
    return note_contradiction(grid, registry()[environment], value, registry()[cycles], fewest,
                              "it changes at cycle " + std::to_string(schedule.back().cycle) +
                                  ", and cycles are numbered from 0 to " +
                                  std::to_string(std::get<std::int64_t>(fewest) - 1),
                              findings);
  }
}

void check_contradictions(const GridValues& grid, Findings& findings) {
  for (const auto& rule : compatibilities()) check_compatibility(rule, grid, findings);
  for (const auto& rule : orders()) check_order(rule, grid, findings);
  check_changes(grid, findings);
}

// ---- which jobs grids share

/// Whether sorted lists have no value in common.
bool disjoint(const std::vector<Value>& a, const std::vector<Value>& b) {
  if (a.back() < b.front() || b.back() < a.front()) return true;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (*i == *j) return false;
    ++(*i < *j ? i : j);
  }
  return true;
}

/// A job that two grids (with sorted values) both have, or nothing.
/// Two cells are the same job if the same parameters apply and have the same values. So each parameter of which the
/// grids have no value in common must not apply: one of its conditions must fail, for values that both grids have of
/// the parameters that conditions ask for. Those parameters are given fewer and fewer values until this is so. What
/// has the fewest ways to fail is tried first, which is why impossible cases end soon.
class CommonJob {
 public:
  CommonJob(const GridValues& a, const GridValues& b) : a_(a), b_(b) {}

  std::optional<Parameters> find() {
    for (std::size_t row = 0; row < registry().size(); ++row) {
      // What is an axis in neither has the same one value in both.
      if ((!a_.is_axis[row] && !b_.is_axis[row]) || !disjoint(a_.values[row], b_.values[row])) continue;
      if (ways_to_fail(row).empty()) return std::nullopt;
      differing_.push_back(row);
    }
    if (!settle()) return std::nullopt;
    Parameters job;
    for (std::size_t row = 0; row < registry().size(); ++row) {
      if (!common(row).empty()) job.set(row, common(row).front());
    }
    return job;
  }

 private:
  /// The values that are left of those that both grids have.
  std::vector<Value>& common(std::size_t row) {
    const auto [found, is_new] = common_.try_emplace(row);
    if (is_new) std::ranges::set_intersection(a_.values[row], b_.values[row], std::back_inserter(found->second));
    return found->second;
  }

  /// Conditions of the row that fail for some of the values that are left.
  std::vector<const RowCondition*> ways_to_fail(std::size_t row) {
    std::vector<const RowCondition*> ways;
    for (const auto& condition : conditions_of(row)) {
      const auto fails = [&](const Value& value) { return !condition.holds(value); };
      if (std::ranges::any_of(common(condition.row), fails)) ways.push_back(&condition);
    }
    return ways;
  }

  /// Whether a condition of the row fails for all values that are left.
  bool cannot_apply(std::size_t row) {
    return std::ranges::any_of(conditions_of(row), [&](const RowCondition& condition) {
      const auto& left = common(condition.row);
      return !left.empty() && std::ranges::none_of(left, [&](const Value& value) { return condition.holds(value); });
    });
  }

  bool settle() {
    std::optional<std::vector<const RowCondition*>> fewest;
    for (const std::size_t row : differing_) {
      if (cannot_apply(row)) continue;
      auto ways = ways_to_fail(row);
      if (!fewest || ways.size() < fewest->size()) fewest = std::move(ways);
    }
    if (!fewest) return true;
    return std::ranges::any_of(*fewest, [&](const RowCondition* condition) {
      const auto before = common(condition->row);
      std::erase_if(common(condition->row), [&](const Value& value) { return condition->holds(value); });
      if (settle()) return true;
      common(condition->row) = before;
      return false;
    });
  }

  const GridValues& a_;
  const GridValues& b_;
  std::map<std::size_t, std::vector<Value>> common_;
  std::vector<std::size_t> differing_;
};

void check_overlap(const GridValues& a, const GridValues& b, Findings& findings) {
  const auto job = CommonJob(a, b).find();
  if (!job) return;
  std::string cell;
  for (std::size_t row = 0; row < registry().size(); ++row) {
    if ((!a.is_axis[row] && !b.is_axis[row]) || !job->applies(row)) continue;
    cell += (cell.empty() ? "" : ", ") + setting_text(registry()[row], (*job)[row]);
  }
  findings.add(b.path, "has jobs " + (a.path == b.path ? std::string("twice") : "that " + a.path + " has too") +
                           " (such as " + cell + "); a sweep runs each job once");
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

}  // namespace

void check_together(const idl::SweepSpecification& specification, std::vector<GridValues> grids, Findings& findings) {
  std::vector<const GridValues*> sound;
  for (auto& grid : grids) {
    if (!findings.any_within(grid.path)) sound.push_back(&grid);
    for (auto& values : grid.values) std::ranges::sort(values);
  }
  const bool all_sound = !findings.any_within("grids");
  for (const auto* grid : sound) {
    check_axes_apply(*grid, findings);
    check_contradictions(*grid, findings);
  }
  for (std::size_t i = 1; i < sound.size(); ++i) {
    for (std::size_t j = 0; j < i && !findings.full(); ++j) check_overlap(*sound[j], *sound[i], findings);
  }
  if (!all_sound) return;
  check_base_applies(specification, grids, findings);
  if (!findings.any_within("replicates")) check_job_count(grids, specification.replicates(), findings);
}

}  // namespace lamprey::experiment
