#include "experiment/parameters.hpp"
#include "storage/view_columns.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace lamprey::storage {

namespace {

using Names = std::vector<std::string_view>;

/// Axes of the published grid that the bar charts average over.
constexpr std::array<std::string_view, 6> averaged_axes = {"equilibrium_disturbance", "mutation_size",
                                                           "system_disturbance",      "required_stability",
                                                           "required_distance",       "required_fuel"};

/// Shown, and grouped by, in every figure.
constexpr std::array<std::string_view, 4> conditions = {"objective", "criterion", "posture", "cycles"};

bool contains(std::span<const std::string_view> names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

/// Grouped by as well, so that no view ever averages jobs that differ in anything but the axes of the published grid,
/// whatever parameters the registry will have.
Column other_parameters(std::span<const std::string_view> grouping) {
  std::string paths;
  for (const auto& parameter : experiment::registry()) {
    if (contains(grouping, parameter.name) || contains(averaged_axes, parameter.name) ||
        contains(conditions, parameter.name)) {
      paths += ", '$." + std::string(parameter.name) + "'";
    }
  }
  return {"other_parameters", "CAST(json_remove(j.parameters" + paths + ") AS TEXT)",
          "JSON object of all other parameters; jobs that differ in one are not averaged"};
}

void add_average(std::vector<Column>& columns, const std::string& column) {
  columns.push_back({column, "avg(j." + column + ")", "Average of " + column});
}

void add_totals(std::vector<Column>& columns) {
  for (const auto* name : {"expected_total", "evolved_total", "highest_total", "final_total"}) {
    add_average(columns, name);
  }
}

/// The bars: stability, distance and fuel, as they are and as they count in the total.
void add_parts(std::vector<Column>& columns) {
  for (const std::string score : {"expected", "evolved", "highest"}) {
    for (const std::string part : {"stability", "distance", "fuel"}) {
      const std::string column = score + "_" + part;
      add_average(columns, column);
      columns.push_back({score + "_weighted_" + part,
                         "avg(" + parameter_column("required_" + part).definition + " * j." + column + " / 100)",
                         "Average of required_" + part + " / 100 × " + column + ": its share in the total"});
    }
  }
}

enum class Detail { totals, parts };

SchemaObject average_view(std::string name, std::string description, const Names& grouping, Detail detail,
                          const std::string& condition) {
  SchemaObject view{std::move(name), std::move(description), {{"sweep", "s.name", "Name of the sweep"}}, ""};
  for (const auto parameter : grouping) view.columns.push_back(parameter_column(parameter));
  for (const auto parameter : conditions) view.columns.push_back(parameter_column(parameter));
  const auto group_columns = view.columns.size();

  view.columns.push_back({"jobs", "count(*)", "Number of jobs averaged"});
  add_totals(view.columns);
  add_average(view.columns, "success_rate");
  if (detail == Detail::parts) add_parts(view.columns);
  // Long, and the same in every row of most sweeps: last.
  view.columns.push_back(other_parameters(grouping));

  view.rest = std::string(jobs_with_sweep) + " WHERE j.state = 'done'" + condition + "\nGROUP BY 1";
  for (std::size_t column = 2; column <= group_columns; ++column) view.rest += ", " + std::to_string(column);
  view.rest += ", " + std::to_string(view.columns.size());
  return view;
}

std::string only(std::string_view parameter, std::string_view value) {
  return " AND " + parameter_column(parameter).definition + " = '" + std::string(value) + "'";
}

SchemaObject bar_chart(const std::string& figure, std::string_view mutation) {
  return average_view(
      "figure_" + figure,
      "Normal against uniform distribution when mutating " + std::string(mutation) +
          ", under each acceptance: a chart per row.",
      {"steps", "acceptance"}, Detail::parts,
      only("mutation", mutation) + " AND " + parameter_column("steps").definition + " IN ('normal', 'uniform')");
}

SchemaObject surface(const std::string& figure, std::string_view steps, std::string_view acceptance) {
  return average_view("figure_" + figure,
                      "Equilibrium disturbance against mutation size, " + std::string(steps) + " distribution, " +
                          std::string(acceptance) + " acceptance: a point of a surface per row.",
                      {"mutation", "equilibrium_disturbance", "mutation_size"}, Detail::totals,
                      only("steps", steps) + only("acceptance", acceptance));
}

}  // namespace

std::vector<SchemaObject> figure_views() {
  return {
      bar_chart("8_3", "all"),
      bar_chart("8_4", "one"),
      bar_chart("8_5", "some"),
      surface("8_6", "normal", "simple"),
      surface("8_7", "normal", "annealing"),
      surface("8_8", "uniform", "simple"),
      surface("8_9", "uniform", "annealing"),
      average_view("figure_8_10", "The 1/5 rule under each mutation and acceptance: a chart per row.",
                   {"mutation", "acceptance"}, Detail::parts, only("steps", "one_fifth_rule")),
      average_view("operators", "Every combination of mutation, steps and acceptance: all bar charts at once.",
                   {"mutation", "steps", "acceptance"}, Detail::parts, ""),
      average_view("disturbance_by_mutation_size",
                   "Equilibrium disturbance against mutation size for every combination of operators: all surfaces at "
                   "once.",
                   {"mutation", "steps", "acceptance", "equilibrium_disturbance", "mutation_size"}, Detail::totals, ""),
  };
}

}  // namespace lamprey::storage
