#include "client/report/claims.hpp"
#include "client/report/judgement.hpp"

#include <algorithm>
#include <array>

/// Claim 10: networks for the wanted walk output (7.4.2, 7.4.3, figs 7.17 and 7.22). Claim 11: changes of gait (9.4,
/// figs 9.5 and 9.6).
namespace lamprey::client::report {

namespace {

constexpr double full_agreement = 100;  ///< of a network's output with the wanted one (fig. 7.13)
constexpr double tens = 100;            ///< "within tens of failures": fewer than this

std::string agreement_sql(const Reading& reading) {
  return "SELECT network, count(*) AS n, min(initial_stability) AS lowest, max(initial_stability) AS highest,\n"
         "  avg(initial_stability) AS initial_stability,\n"
         "  avg(initial_stability * initial_stability) AS initial_stability_squared,\n"
         "  sum(cycles > 1) AS trained, avg(CASE WHEN cycles > 1 THEN highest_stability END) AS highest_stability,\n"
         "  avg(CASE WHEN cycles > 1 THEN highest_stability * highest_stability END) AS highest_stability_squared\n"
         "FROM result WHERE " +
         reading.condition() + " AND coalesce(equilibrium_disturbance, 0) = 0\nGROUP BY network ORDER BY network";
}

/// The mean with the lowest and the highest value: nothing is drawn at random, so that this is all there is to know.
MaybeInterval range_of(const Rows& rows, std::size_t row) {
  const auto mean = rows.number(row, "initial_stability");
  if (!mean) return std::nullopt;
  return statistics::Interval{*mean, rows.number(row, "lowest").value_or(*mean),
                              rows.number(row, "highest").value_or(*mean), 1,
                              static_cast<std::uint64_t>(rows.number(row, "n").value_or(0))};
}

}  // namespace

std::vector<Part> assess_wanted_output(const Evidence& evidence, const Reading& reading) {
  const auto sql = agreement_sql(reading);
  const auto rows = evidence.query(sql);
  std::vector<Part> parts;
  for (const std::string network : {"recurrent_eight", "one_mother"}) {
    const bool matches = network == "one_mother";
    const auto row = find_row(rows, {{"network", network}});
    parts.push_back(
        part_of(network + ": agreement as set up", matches ? "100 %" : "below 100 %",
                "As set up: the share of steps and neurons in which the undisturbed network puts out what is "
                "wanted (in brackets the least and the greatest of all jobs): below 100 % for the recurrent "
                "network, 100 % for the single mother.",
                sql));
    parts.back().unit = "%";
    if (!row) continue;
    const auto range = range_of(rows, *row);
    const bool holds = range && (matches ? range->low >= full_agreement : range->high < full_agreement);
    parts.back().measured.push_back(judged("initial_stability", range, holds));
  }
  if (const auto row = find_row(rows, {{"network", "recurrent_eight"}})) {
    parts.push_back(
        part_of("recurrent_eight: agreement once trained", "below 100 %",
                "Once trained (shown beside, judges nothing; 7.4.2 expects that training the weights may not be "
                "efficient): the mean of the best agreement that each job reached.",
                sql));
    parts.back().unit = "%";
    parts.back().decisive = false;
    const auto interval = statistics::mean_interval(sample_in(rows, *row, "highest_stability", "trained"), confidence);
    parts.back().measured.push_back(below("highest_stability", interval, full_agreement));
  }
  return parts;
}

namespace {

std::string failures_sql(const Reading& reading) {
  return "WITH failure AS (\n"
         "  SELECT r.mutation, m.value AS failures\n"
         "  FROM result AS r JOIN measure AS m ON m.sweep = r.sweep AND m.job = r.job\n"
         "  WHERE m.name = 'gait_change_failures' AND r." +
         reading.condition() +
         "),\nranked AS (SELECT mutation, failures, cume_dist() OVER (PARTITION BY mutation ORDER BY failures) AS "
         "share\n"
         "  FROM failure)\n"
         "SELECT mutation, count(*) AS n, avg(failures) AS failures, avg(failures * failures) AS failures_squared,\n"
         "  min(CASE WHEN share >= 0.95 THEN failures END) AS quantile, max(failures) AS most\n"
         "FROM ranked GROUP BY mutation ORDER BY mutation";
}

/// Jobs per technique, those of them that changed gait at all, and failures that still waited for a change at the end.
std::string changes_sql(const Reading& reading) {
  const auto counted = [](const std::string& name, const std::string& value) {
    return "    (SELECT " + value + " FROM measure AS m WHERE m.sweep = r.sweep AND m.job = r.job AND m.name = '" +
           name + "')";
  };
  return "WITH job AS (\n  SELECT r.mutation,\n" + counted("gait_reached", "count(*)") + " AS changes,\n" +
         counted("failures_after_last_change", "max(m.value)") + " AS waiting\n  FROM result AS r WHERE r." +
         reading.condition() +
         ")\nSELECT mutation, count(*) AS n, sum(changes > 0) AS changed, sum(changes) AS changes,\n"
         "  sum(coalesce(waiting, 0) < 100) AS not_waiting\nFROM job GROUP BY mutation ORDER BY mutation";
}

std::string gaits_sql(const Reading& reading) {
  return "SELECT r.mutation, count(DISTINCT m.value) AS gaits, count(*) AS n\n"
         "FROM result AS r JOIN measure AS m ON m.sweep = r.sweep AND m.job = r.job\n"
         "WHERE m.name = 'gait_reached' AND r." +
         reading.condition() + "\nGROUP BY r.mutation ORDER BY r.mutation";
}

MaybeInterval share_of(const Rows& rows, std::size_t row, const std::string& column) {
  const auto count = [&](const std::string& name) {
    return static_cast<std::uint64_t>(rows.number(row, name).value_or(0));
  };
  return in_per_cent(statistics::wilson_interval(count(column), count("n"), confidence));
}

}  // namespace

std::vector<Part> assess_gait_change(const Evidence& evidence, const Reading& reading) {
  const auto failures_query = failures_sql(reading);
  const auto changes_query = changes_sql(reading);
  const auto gaits_query = gaits_sql(reading);
  const auto failures = evidence.query(failures_query);
  const auto changes = evidence.query(changes_query);
  const auto gaits = evidence.query(gaits_query);
  std::vector<Part> parts;
  for (const std::string mutation : {"all", "one"}) {
    const auto row = find_row(failures, {{"mutation", mutation}});
    const auto of = "mutate " + mutation + ": ";
    parts.push_back(
        part_of(of + "mean failures per change", "below 100",
                "Within tens: the 95 % t interval of the mean number of failures before a change lies below 100.",
                failures_query));
    if (row) {
      const auto mean = statistics::mean_interval(sample_in(failures, *row, "failures"), confidence);
      parts.back().measured.push_back(below("gait_change_failures", mean, tens));
    }
    parts.push_back(
        part_of(of + "95 % of changes within", "below 100",
                "Within tens, nearly always: 95 % of the changes took fewer than 100 failures (the empirical "
                "quantile; in brackets up to the longest).",
                failures_query));
    if (row) {
      const double quantile = failures.number(*row, "quantile").value_or(0);
      const statistics::Interval range{quantile, quantile, failures.number(*row, "most").value_or(quantile), 0.95,
                                       static_cast<std::uint64_t>(failures.number(*row, "n").value_or(0))};
      parts.back().measured.push_back(judged("gait_change_failures", range, quantile < tens));
    }
    parts.push_back(part_of(
        of + "jobs that changed gait", "all",
        "Reached: every job changed its gait at least once; with Wilson's 95 % interval of the share.", changes_query));
    parts.back().unit = "%";
    Part waiting = parts.back();
    waiting.name = of + "jobs not stuck at the end";
    if (const auto found = find_row(changes, {{"mutation", mutation}})) {
      const auto changed = share_of(changes, *found, "changed");
      const auto moving = share_of(changes, *found, "not_waiting");
      parts.back().measured.push_back(judged("gait_reached", changed, changed && changed->estimate >= 100));
      waiting.measured.push_back(judged("failures_after_last_change", moving, moving && moving->low >= 95));
    }
    waiting.expectation = "95 %";
    waiting.rule =
        "Not stuck: Wilson's 95 % interval of the share of jobs that end with fewer than 100 failures since "
        "their last change lies at or above 95 %.";
    parts.push_back(std::move(waiting));
    parts.push_back(part_of(of + "different gaits reached", "4",
                            "New gaits: all four of the table in 9.3 were reached.", gaits_query));
    if (const auto found = find_row(gaits, {{"mutation", mutation}})) {
      const double number = gaits.number(*found, "gaits").value_or(0);
      const statistics::Interval exact{number, number, number, 1,
                                       static_cast<std::uint64_t>(gaits.number(*found, "n").value_or(0))};
      parts.back().measured.push_back(judged("gait_reached", exact, number >= 4));
    }
  }
  return parts;
}

}  // namespace lamprey::client::report
