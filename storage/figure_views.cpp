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

/// What a chapter's averages never tell apart: its grid's axes beside those shown.
Column all_but(const Names& grouping, std::span<const std::string_view> averaged) {
  Names shown = grouping;
  shown.insert(shown.end(), averaged.begin(), averaged.end());
  shown.insert(shown.end(), conditions.begin(), conditions.end());
  return other_parameters(shown);
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

/// A view that averages done jobs over the axes `averaged`.
struct Average {
  std::string name;
  std::string description;
  Names grouping;
  Detail detail = Detail::totals;
  std::string condition;
  std::span<const std::string_view> averaged = averaged_axes;
};

SchemaObject average_view(const Average& average) {
  SchemaObject view{average.name, average.description, {{"sweep", "s.name", "Name of the sweep"}}, ""};
  for (const auto parameter : average.grouping) view.columns.push_back(parameter_column(parameter));
  for (const auto parameter : conditions) view.columns.push_back(parameter_column(parameter));
  const auto group_columns = view.columns.size();

  view.columns.push_back({"jobs", "count(*)", "Number of jobs averaged"});
  add_totals(view.columns);
  add_average(view.columns, "success_rate");
  if (average.detail == Detail::parts) add_parts(view.columns);
  // Long, and the same in every row of most sweeps: last.
  view.columns.push_back(all_but(average.grouping, average.averaged));

  view.rest = std::string(jobs_with_sweep) + " WHERE j.state = 'done'" + average.condition + "\nGROUP BY 1";
  for (std::size_t column = 2; column <= group_columns; ++column) view.rest += ", " + std::to_string(column);
  view.rest += ", " + std::to_string(view.columns.size());
  return view;
}

/// Chapter 8 is about one system; a sweep may hold others too.
std::string of_chapter_8() {
  return only("network", {"four_mother"}) + only("trainer", {"rtea"});
}

SchemaObject bar_chart(const std::string& figure, std::string_view mutation) {
  return average_view({"figure_" + figure,
                       "Normal against uniform distribution when mutating " + std::string(mutation) +
                           ", under each acceptance: a chart per row.",
                       {"steps", "acceptance"},
                       Detail::parts,
                       of_chapter_8() + only("mutation", {mutation}) + only("steps", {"normal", "uniform"})});
}

SchemaObject surface(const std::string& figure, std::string_view steps, std::string_view acceptance) {
  return average_view({"figure_" + figure,
                       "Equilibrium disturbance against mutation size, " + std::string(steps) + " distribution, " +
                           std::string(acceptance) + " acceptance: a point of a surface per row.",
                       {"mutation", "equilibrium_disturbance", "mutation_size"},
                       Detail::totals,
                       of_chapter_8() + only("steps", {steps}) + only("acceptance", {acceptance})});
}

/// Figures 6.25, 6.27 and 6.30: networks of two neurons by mutation rate. Only replicates are averaged.
SchemaObject mutation_rates(const std::string& figure, std::string description, std::string_view trainer) {
  return average_view({"figure_" + figure,
                       std::move(description),
                       {"network", "neuron", "mutation_rate"},
                       Detail::totals,
                       only("network", {"recurrent_pair", "feed_forward_pair"}) + only("trainer", {trainer}),
                       {}});
}

/// Figures 9.5 and 9.6: failures before each change of gait.
SchemaObject gait_changes(const std::string& figure, std::string_view mutation) {
  const Names shown = {"mutation", "tonic_genes", "cycles"};
  return {"figure_" + figure,
          "Failures before each change of gait when mutating " + std::string(mutation) + ": a bar per row.",
          {{"sweep", "s.name", "Name of the sweep"},
           parameter_column("tonic_genes"),
           parameter_column("cycles"),
           {"change", "CAST(" + measure_index() + " AS INTEGER)", "Number of the change within the run, from 0"},
           {"jobs", "count(*)", "Number of jobs that have changed their gait so often"},
           {"failures", "avg(" + measure_value() + ")", "Average number of failures before that change"},
           other_parameters(shown)},
          std::string(jobs_with_sweep) + std::string(measures_of_jobs) + " WHERE j.state = 'done'" +
              only("network", {"tonic"}) + only("mutation", {mutation}) + " AND " + measure_name() +
              " = 'gait_change_failures'\nGROUP BY 1, 2, 3, 4, 7"};
}

std::vector<SchemaObject> figures_of_chapter_6() {
  return {
      mutation_rates("6_25", "The genetic algorithm of chapter 6: each network under each mutation rate.",
                     "chapter_6_ga"),
      mutation_rates("6_27", "Mutation rates of the genetic algorithm of chapter 6: the highest totals side by side.",
                     "chapter_6_ga"),
      mutation_rates("6_30", "The II-RTEA: each network under each mutation rate.", "ii_rtea")};
}

std::vector<SchemaObject> figures_of_chapter_8() {
  return {
      bar_chart("8_3", "all"),
      bar_chart("8_4", "one"),
      bar_chart("8_5", "some"),
      surface("8_6", "normal", "simple"),
      surface("8_7", "normal", "annealing"),
      surface("8_8", "uniform", "simple"),
      surface("8_9", "uniform", "annealing"),
      average_view({"figure_8_10",
                    "The 1/5 rule under each mutation and acceptance: a chart per row.",
                    {"mutation", "acceptance"},
                    Detail::parts,
                    of_chapter_8() + only("steps", {"one_fifth_rule"})}),
      average_view({"operators",
                    "Every combination of mutation, steps and acceptance: all bar charts of chapter 8 at once.",
                    {"mutation", "steps", "acceptance"},
                    Detail::parts,
                    of_chapter_8()}),
      average_view({"disturbance_by_mutation_size",
                    "Equilibrium disturbance against mutation size for every combination of operators: all surfaces of "
                    "chapter 8 at once.",
                    {"mutation", "steps", "acceptance", "equilibrium_disturbance", "mutation_size"},
                    Detail::totals,
                    of_chapter_8()}),
  };
}

}  // namespace

Column other_parameters(std::span<const std::string_view> shown) {
  std::string paths;
  for (const auto& parameter : experiment::registry()) {
    if (std::ranges::find(shown, parameter.name) != shown.end()) paths += ", '$." + std::string(parameter.name) + "'";
  }
  return {"other_parameters", "CAST(json_remove(j.parameters" + paths + ") AS TEXT)",
          "JSON object of all other parameters; jobs that differ in one are not averaged"};
}

std::string only(std::string_view parameter, std::initializer_list<std::string_view> values) {
  std::string list;
  for (const auto value : values) list += (list.empty() ? "'" : ", '") + std::string(value) + "'";
  return " AND " + parameter_column(parameter).definition + " IN (" + list + ")";
}

std::vector<SchemaObject> figure_views() {
  std::vector<SchemaObject> all = figures_of_chapter_6();
  for (auto& view : figures_of_chapter_8()) all.push_back(std::move(view));
  all.push_back(gait_changes("9_5", "all"));
  all.push_back(gait_changes("9_6", "one"));
  return all;
}

}  // namespace lamprey::storage
