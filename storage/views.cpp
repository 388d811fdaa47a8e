#include "experiment/models.hpp"
#include "storage/job_row.hpp"
#include "storage/view_columns.hpp"

namespace lamprey::storage {

namespace {

std::string_view sql_type(experiment::ParameterKind kind) {
  switch (kind) {
    case experiment::ParameterKind::choice:
    case experiment::ParameterKind::schedule:
      return "TEXT";
    case experiment::ParameterKind::integer:
      return "INTEGER";
    case experiment::ParameterKind::real:
      return "REAL";
  }
  throw std::logic_error("a parameter kind without an SQL type");
}

/// `parameter IN (the models that are only that repeatable)`; nothing if there are none.
template <typename Models>
std::string condition_of(std::string_view parameter, const Models& models, experiment::Repeatability repeatability) {
  std::string names;
  for (const auto& model : models) {
    if (model.repeatability == repeatability) names += (names.empty() ? "'" : ", '") + std::string(model.name) + "'";
  }
  if (names.empty()) return names;
  return parameter_column(parameter).definition + " IN (" + names + ")";
}

/// The weakest of the robot's, the network's and the trainer's, as experiment::repeatability has it.
std::string repeatability_sql() {
  using experiment::Repeatability;
  std::string sql = "CAST(CASE WHEN j.state <> 'done' THEN NULL WHEN " + parameter_column("robot").definition +
                    real_robots() + " THEN '" + std::string(to_text(Repeatability::physical)) + "'";
  for (const auto repeatability : {Repeatability::physical, Repeatability::same_build}) {
    for (const auto& condition : {condition_of("network", experiment::network_models(), repeatability),
                                  condition_of("trainer", experiment::trainer_models(), repeatability)}) {
      if (condition.empty()) continue;
      sql += " WHEN " + condition + " THEN '" + std::string(to_text(repeatability)) + "'";
    }
  }
  return sql + " ELSE '" + std::string(to_text(Repeatability::bitwise)) + "' END AS TEXT)";
}

SchemaObject result_view() {
  SchemaObject view{"result",
                    "One row per job that has ended, with one column per parameter.",
                    {
                        {"sweep", "s.name", "Name of the sweep"},
                        {"job", "j.job", "Number of the job within its sweep, from 0"},
                        {"state", "j.state", "done, failed, quarantined or cancelled"},
                        {"digest", "CAST(nullif(lower(hex(j.digest)), '') AS TEXT)",
                         "SHA-256 over the job's identity and outcome, 64 hex digits; NULL unless done"},
                        {"attempt", "j.attempt", "Which attempt this is the end of, from 1"},
                        {"worker", "CAST(CASE WHEN j.worker IS NOT NULL THEN printf('%016x', j.worker) END AS TEXT)",
                         "The worker that computed it, 16 hex digits; NULL if none did"},
                        // SQLite's integers are signed; a seed that needs the 64th bit is shown as text rather than as
                        // a wrong number.
                        {"seed", "CASE WHEN j.seed < 0 THEN printf('%u', j.seed) ELSE j.seed END",
                         "Seed of its random streams; decimal text from 2^63 on"},
                        {"replicate", "j.replicate", "Number of its replicate, from 0"},
                    },
                    std::string(jobs_with_sweep)};
  for (const auto& parameter : experiment::registry()) view.columns.push_back(parameter_column(parameter.name));
  for (const auto& score : job_scores()) {
    for (const auto& part : score_parts()) {
      const std::string name = score.prefix + "_" + part.name;
      view.columns.push_back({name, "CAST(j." + name + " AS REAL)", part.meaning + " " + score.meaning});
    }
  }
  view.columns.push_back({"success_rate", "CAST(j.success_rate AS REAL)", "Eq. 8.1: successes / cycles"});
  view.columns.push_back({"seconds", "j.seconds", "Time that its computation took; not deterministic"});
  view.columns.push_back({"repeatability", repeatability_sql(),
                          "bitwise: any machine computes the same bits again; same_build: only the same build does; "
                          "physical: a robot did it, and nothing does it again; NULL unless done"});
  return view;
}

SchemaObject trace_view() {
  const auto element = [](int index, std::string_view type) {
    return "CAST(json_extract(t.value, '$[" + std::to_string(index) + "]') AS " + std::string(type) + ")";
  };
  return {
      "trace",
      "One row per accepted change of each job. Ask for one sweep and few jobs: a large sweep has millions of rows.",
      {
          {"sweep", "s.name", "Name of the sweep"},
          {"job", "j.job", "Number of the job within its sweep, from 0"},
          {"cycle", element(0, "INTEGER"), "Cycle whose mutation was accepted, from 0"},
          {"stability", element(1, "REAL"), "Stability (eq. 7.5) after it"},
          {"distance", element(2, "REAL"), "Distance (eq. 7.7) after it"},
          {"fuel", element(3, "REAL"), "Fuel (eq. 7.9) after it"},
          {"total", element(4, "REAL"), "Weighted total (eq. 7.4) after it"},
      },
      std::string(jobs_with_sweep) + " JOIN json_each(j.trace) AS t"};
}

}  // namespace

Column parameter_column(std::string_view parameter) {
  const auto& row = experiment::registry()[experiment::parameter_index(parameter)];
  const std::string name(row.name);
  std::string description(row.meaning.substr(0, row.meaning.find_last_not_of('.') + 1));
  if (!row.unit.empty()) description += " (" + std::string(row.unit) + ")";
  if (!row.applies_when.empty()) description += "; NULL where it doesn't apply";
  return {name, "CAST(json_extract(j.parameters, '$." + name + "') AS " + std::string(sql_type(row.kind)) + ")",
          description};
}

std::vector<SchemaObject> views() {
  std::vector<SchemaObject> all = {result_view(), trace_view()};
  for (auto& view : history_views()) all.push_back(std::move(view));
  for (auto& view : measure_views()) all.push_back(std::move(view));
  for (auto& view : robot_views()) all.push_back(std::move(view));
  for (auto& view : figure_views()) all.push_back(std::move(view));
  return all;
}

std::string view_sql(const SchemaObject& view) {
  std::string sql = "CREATE VIEW " + quoted(view.name) + " AS SELECT";
  for (const auto& column : view.columns) {
    sql += (&column == &view.columns.front() ? "\n  " : ",\n  ") + column.definition + " AS " + quoted(column.name);
  }
  return sql + "\n" + view.rest;
}

}  // namespace lamprey::storage
