#include "experiment/models.hpp"
#include "experiment/parameters.hpp"
#include "storage/recording.hpp"
#include "storage/view_columns.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace lamprey::storage {

namespace {

/// The value of the parameter `robot` whose jobs those on a robot are held against.
constexpr std::string_view simulated_robot = "quadruped";

/// Of what kind the value of `robot` is: no registry says it but experiment::on_a_robot.
bool is_real(std::string_view robot) {
  experiment::Parameters parameters;
  parameters.set("robot", std::string(robot));
  return experiment::on_a_robot(parameters);
}

std::string robot_of(const std::string& row) {
  return "json_extract(" + row + ".parameters, '$.robot')";
}

SchemaObject recordings_view() {
  const auto of_tries = [](const std::string& what) {
    return "(SELECT " + what + " FROM robot_evaluation AS e WHERE e.recording = r.recording)";
  };
  return {"recordings",
          "One row per attempt of a job on a robot of which there is a recording.",
          {{"sweep", "s.name", "Name of the sweep"},
           {"job", "r.job", "Number of the job within its sweep, from 0"},
           {"attempt", "r.number", "Which of the job's recorded attempts it is, from 1"},
           {"robot", "r.robot", "Name of the robot"},
           {"token", "r.token", "Number of the claim that the robot was moved under"},
           worker_key("r", "The worker that had the job, 16 hex digits"),
           {"state", "r.state", "How the attempt ended: done or failed"},
           {"accepted", "r.accepted", "1 if the job's row is its outcome; of a job's attempts at most one is"},
           {"evaluations", of_tries("count(*) FILTER (WHERE e.voided IS NULL)"), "Number of evaluations that count"},
           {"voided", of_tries("count(e.voided)"), "Number of tries that were worth nothing and were tried again"},
           {"time_steps", of_tries("coalesce(sum(e.steps), 0)"), "Number of time steps of all tries"},
           {"measured", of_tries("min(e.measured)"),
            "1 if sensors measured what is reported, 0 if the device interpolates its commands; NULL of no try"},
           {"ended", utc_time("r.at"), "When it was stored, UTC"}},
          "FROM recording AS r JOIN sweep AS s ON s.sweep = r.sweep"};
}

/// The servo's name as pictures have it; they are numbered as in science/robots/quadruped.hpp: the front ones first,
/// vertical before horizontal, left before right.
std::string servo_name(const std::string& servo) {
  const auto part = [&](const char* bits, const char* unset, const char* set) {
    return "CASE WHEN " + servo + " & " + bits + " THEN '" + set + "' ELSE '" + unset + "' END";
  };
  return part("4", "front ", "back ") + " || " + part("1", "left ", "right ") + " || " +
         part("2", "vertical", "horizontal");
}

SchemaObject motion_view() {
  const std::string servos = std::to_string(robot_servos);
  const std::string servo = "(c.key % " + servos + ")";
  const std::string step = "(c.key / " + servos + ")";
  const std::string unit = std::to_string(static_cast<int>(position_unit)) + ".0";
  const auto element = [](const std::string& list, const std::string& index) {
    return "json_extract(e." + list + ", '$[' || " + index + " || ']')";
  };
  return {
      "motion",
      "One row per servo and time step of each try of an evaluation on a robot. Ask for one job and few evaluations: "
      "each try of 100 time steps has 808 rows.",
      {{"sweep", "s.name", "Name of the sweep"},
       {"job", "r.job", "Number of the job within its sweep, from 0"},
       {"attempt", "r.number", "Which of the job's recorded attempts it is, from 1"},
       {"evaluation", "e.evaluation", "Number of the evaluation within the job: 0 of the first genes"},
       {"try", "e.attempt", "Which try of the evaluation it is, from 0"},
       {"counts", "e.voided IS NULL", "1 if the try counts, 0 if the evaluation was tried again"},
       {"step", step, "Number of the time step; 0: where the try began"},
       {"servo", "CAST(" + servo_name(servo) + " AS TEXT)", "Name of the servo: front left vertical and so on"},
       {"commanded", "c.value / " + unit, "Where it was sent, after all limits (positions)"},
       {"reported", element("reported", "c.key") + " / " + unit, "Where the robot said that it was (positions)"},
       {"foot_down", "(" + element("feet", step) + " >> (" + servo + " / 4 * 2 + " + servo + " % 2)) & 1",
        "1 if the foot of the servo's leg was on the ground"}},
      "FROM recording AS r JOIN sweep AS s ON s.sweep = r.sweep JOIN robot_evaluation AS e ON e.recording = "
      "r.recording JOIN json_each(e.commanded) AS c"};
}

/// Parameters that only a simulated robot has.
std::vector<std::string_view> parameters_of_simulation() {
  const std::size_t robot = experiment::parameter_index("robot");
  const experiment::Value simulated = std::string(simulated_robot);
  std::vector<std::string_view> names;
  for (std::size_t row = 0; row < experiment::registry().size(); ++row) {
    const auto conditions = experiment::conditions_of(row);
    const bool its_own = std::ranges::any_of(conditions, [&](const experiment::RowCondition& condition) {
      if (condition.row != robot || !condition.holds(simulated)) return false;
      const auto& robots = experiment::registry()[robot].choices;
      return std::ranges::none_of(
          robots, [&](std::string_view choice) { return is_real(choice) && condition.holds(std::string(choice)); });
    });
    if (its_own) names.push_back(experiment::registry()[row].name);
  }
  return names;
}

/// What a job on a robot and its simulation have in common.
std::string common_parameters(const std::string& row) {
  std::string sql = "json_remove(" + row + ".parameters, '$.robot'";
  for (const auto name : parameters_of_simulation()) sql += ", '$." + std::string(name) + "'";
  return sql + ")";
}

/// How many of the simulation's own parameters are not at their defaults.
std::string peculiarities(const std::string& row) {
  std::string sql = "0";
  for (const auto name : parameters_of_simulation()) {
    const auto& value = experiment::registry()[experiment::parameter_index(name)].default_value;
    const bool is_text = std::holds_alternative<std::string>(value);
    const std::string text = experiment::to_text(value);
    sql += " + (json_extract(" + row + ".parameters, '$." + std::string(name) + "') IS NOT " +
           (is_text ? "'" + text + "'" : text) + ")";
  }
  return sql;
}

/// The row of the simulation of `j`. All simulations are gathered once, which LIMIT makes SQLite do, and found by an
/// index that it makes. What ORDER BY goes by has names of its own since SQLite sees nothing of `j` there.
std::string twin() {
  const std::string simulations =
      "(SELECT q.rowid AS twin, q.sweep AS sweep, q.job AS job, q.seed AS seed, q.replicate AS replicate, " +
      common_parameters("q") + " AS cell, " + peculiarities("q") +
      " AS peculiarities FROM job AS q WHERE q.state = 'done' AND " + robot_of("q") + " = '" +
      std::string(simulated_robot) + "' LIMIT -1)";
  return "(SELECT d.twin FROM (SELECT c.twin, c.sweep <> j.sweep AS elsewhere, c.peculiarities, c.sweep, c.job FROM " +
         simulations + " AS c WHERE c.cell = " + common_parameters("j") +
         " AND c.seed = j.seed AND c.replicate = j.replicate) AS d "
         "ORDER BY d.elsewhere, d.peculiarities, d.sweep, d.job LIMIT 1)";
}

/// A list of changes as rows of cycle and total, beside an empty column of the other's: after its initial total.
std::string changes(const std::string& row, bool first) {
  const auto columns = [&](const std::string& total) { return first ? total + " AS a, NULL AS b" : "NULL, " + total; };
  return "SELECT -1 AS cycle, " + columns(row + ".initial_total") + " UNION ALL SELECT json_extract(value, '$[0]'), " +
         columns("json_extract(value, '$[4]')") + " FROM json_each(" + row + ".trace)";
}

/// The largest distance between the totals of `j` and `t`: each lasts until the next change. In rows by cycle of which
/// each has a total of one of them or both, the totals without a gap number the stretches over which they last.
std::string trace_distance() {
  const std::string all = changes("j", true) + " UNION ALL " + changes("t", false) + " UNION ALL SELECT 0, NULL, NULL";
  const std::string by_cycle = "SELECT cycle, max(a) AS a, max(b) AS b FROM (" + all + ") GROUP BY cycle";
  const std::string stretches =
      "SELECT cycle, a, b, count(a) OVER (ORDER BY cycle) AS of_a, count(b) OVER (ORDER BY cycle) AS of_b FROM (" +
      by_cycle + ")";
  const std::string carried =
      "SELECT cycle, max(a) OVER (PARTITION BY of_a) AS a, max(b) OVER (PARTITION BY of_b) AS b FROM (" + stretches +
      ")";
  return "CASE WHEN t.job IS NOT NULL THEN (SELECT max(abs(a - b)) FROM (" + carried + ") WHERE cycle >= 0) END";
}

SchemaObject gap_view() {
  SchemaObject view{
      "gap",
      "One row per done job on a robot: how far it is from the same job in simulation, and which job that is.",
      {{"sweep", "s.name", "Name of the sweep"},
       {"job", "j.job", "Number of the job within its sweep, from 0"},
       {"robot", "(SELECT r.robot FROM recording AS r WHERE r.sweep = j.sweep AND r.job = j.job AND r.accepted = 1)",
        "Name of the robot; NULL if there is no recording"},
       {"simulated_sweep", "u.name", "Name of the sweep of the simulated job; NULL if there is none"},
       {"simulated_job", "t.job", "Number of the simulated job within that sweep"}},
      "FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep LEFT JOIN job AS t ON t.rowid = " + twin() +
          " LEFT JOIN sweep AS u ON u.sweep = t.sweep\nWHERE j.state = 'done' AND " + robot_of("j") + real_robots()};
  const auto difference = [&](const std::string& name, const std::string& column, const std::string& meaning) {
    view.columns.push_back({name, "CAST(j." + column + " - t." + column + " AS REAL)",
                            meaning + ", the robot's less the simulated one; NULL if there is none"});
  };
  difference("stability", "final_stability", "Final stability");
  difference("distance", "final_distance", "Final distance");
  difference("fuel", "final_fuel", "Final fuel");
  difference("total", "final_total", "Final total");
  difference("highest_total", "highest_total", "Highest total");
  view.columns.push_back(
      {"trace_distance", "CAST(" + trace_distance() + " AS REAL)",
       "The largest distance between the accepted totals of the two at the same cycle; NULL likewise"});
  return view;
}

}  // namespace

std::string real_robots() {
  std::string names;
  for (const auto choice : experiment::registry()[experiment::parameter_index("robot")].choices) {
    if (is_real(choice)) names += (names.empty() ? "'" : ", '") + std::string(choice) + "'";
  }
  return " IN (" + names + ")";
}

std::vector<SchemaObject> robot_views() {
  return {recordings_view(), motion_view(), gap_view()};
}

}  // namespace lamprey::storage
