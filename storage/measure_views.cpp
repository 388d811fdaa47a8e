#include "experiment/parameters.hpp"
#include "storage/view_columns.hpp"

namespace lamprey::storage {

namespace {

std::string typed(const std::string& expression, std::string_view type) {
  return "CAST(" + expression + " AS " + std::string(type) + ")";
}

/// FROM clause of a view with a row per measure of that name.
std::string rows_of(std::string_view name) {
  return std::string(jobs_with_sweep) + std::string(measures_of_jobs) + " WHERE " + measure_name() + " = '" +
         std::string(name) + "'";
}

std::vector<Column> job_key() {
  return {{"sweep", "s.name", "Name of the sweep"}, {"job", "j.job", "Number of the job within its sweep, from 0"}};
}

SchemaObject measure_view() {
  SchemaObject view{"measure", "One row per number that only some jobs tell; docs/formats/measures.md lists the names.",
                    job_key(), std::string(jobs_with_sweep) + std::string(measures_of_jobs)};
  view.columns.insert(view.columns.end(),
                      {{"name", typed(measure_name(), "TEXT"), "What it is"},
                       {"index", typed(measure_index(), "INTEGER"), "Number of the change or cycle that it is about"},
                       {"value", typed(measure_value(), "REAL"), "The number"}});
  return view;
}

SchemaObject recovery_view() {
  SchemaObject view{"recovery", "One row per change of the environment in each job: whether and how soon it recovered.",
                    job_key(), rows_of("recovered")};
  auto& columns = view.columns;
  columns.push_back({"replicate", "j.replicate", "Number of its replicate, from 0"});
  for (const auto parameter : {"mutation", "steps", "acceptance", "criterion"}) {
    columns.push_back(parameter_column(parameter));
  }
  columns.push_back({"change", typed(measure_index(), "INTEGER"), "Number of the change within the run, from 0"});
  columns.push_back({"environment_expected_total", typed(measure_beside("environment_expected_total"), "REAL"),
                     "Total of the undisturbed gait in the new environment"});
  columns.push_back({"recovered", typed(measure_value(), "INTEGER"),
                     "1 if an accepted total has come within 5 % of that before the next change, else 0"});
  columns.push_back({"recovery_cycles", typed(measure_beside("recovery_cycles"), "INTEGER"),
                     "Cycles from the change until then; NULL if it has not recovered"});
  return view;
}

SchemaObject gait_change_view() {
  SchemaObject view{"gait_change", "One row per change of gait in each job of the tonic network.", job_key(),
                    rows_of("gait_reached")};
  auto& columns = view.columns;
  columns.push_back({"replicate", "j.replicate", "Number of its replicate, from 0"});
  columns.push_back(parameter_column("mutation"));
  columns.push_back(parameter_column("tonic_genes"));
  columns.push_back({"change", typed(measure_index(), "INTEGER"), "Number of the change within the run, from 0"});
  columns.push_back({"gait_reached",
                     typed("CASE " + measure_value() +
                               " WHEN 1 THEN 'walk' WHEN 2 THEN 'gallop' WHEN 3 THEN 'trot' WHEN 4 THEN 'pace' END",
                           "TEXT"),
                     "The gait that it changed to: walk, gallop, trot or pace"});
  columns.push_back({"failures", typed(measure_beside("gait_change_failures"), "INTEGER"),
                     "Mutations before that change whose tonic was no other gait's"});
  return view;
}

/// Figures 6.26 and 6.31. The measures are gathered first, which LIMIT makes SQLite do, and looked up by an index that
/// it makes for the order that CROSS JOIN fixes: each looked up in its job's list would take that list apart once per
/// row.
SchemaObject variation_view() {
  const std::string cycle = "json_extract(t.value, '$[0]')";
  const std::string moved = "(SELECT j.sweep AS sweep, j.job AS job, " + measure_index() + " AS cycle, " +
                            measure_value() + " AS variation FROM job AS j" + std::string(measures_of_jobs) +
                            " WHERE " + measure_name() + " = 'parameter_variation' LIMIT -1)";
  SchemaObject view{"variation",
                    "One row per accepted change of each job with record: details: how far the genes have moved, and "
                    "the fitness.",
                    job_key(),
                    std::string(jobs_with_sweep) + " CROSS JOIN json_each(j.trace) AS t CROSS JOIN " + moved +
                        " AS v ON v.sweep = j.sweep AND v.job = j.job AND v.cycle = " + cycle +
                        "\nWHERE j.measures IS NOT NULL"};
  view.columns.push_back({"cycle", typed(cycle, "INTEGER"), "Cycle whose mutation was accepted, from 0"});
  view.columns.push_back({"parameter_variation", typed("v.variation", "REAL"),
                          "Mean over the genes of how far each is from its first value"});
  view.columns.push_back(
      {"total", typed("json_extract(t.value, '$[4]')", "REAL"), "Weighted total (eq. 7.4) after it"});
  return view;
}

}  // namespace

std::string measure_beside(std::string_view name) {
  return "(SELECT " + measure_value("o") + " FROM json_each(j.measures) AS o WHERE " + measure_name("o") + " = '" +
         std::string(name) + "' AND " + measure_index("o") + " = " + measure_index() + ")";
}

std::vector<SchemaObject> measure_views() {
  return {measure_view(), recovery_view(), gait_change_view(), variation_view()};
}

}  // namespace lamprey::storage
