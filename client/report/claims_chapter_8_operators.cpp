#include "client/report/chapter_8_queries.hpp"
#include "client/report/claims.hpp"
#include "client/report/judgement.hpp"

#include <array>
#include <cmath>

/// Claims 1 to 5: operators of the RTEA (8.3.1, 8.3.3, 8.4).
namespace lamprey::client::report {

namespace {

using statistics::mean_interval;
using statistics::welch_interval;

constexpr std::array mutations = {"all", "one", "some"};
constexpr std::array acceptances = {"simple", "annealing"};

const char* const either_steps = "steps IN ('normal', 'uniform')";
const char* const paired_above_0 =
    "the 95 % t interval of the paired differences over grid cells (jobs that agree in all other parameters) lies "
    "above "
    "0.";
const char* const equivalence_of_fitness =
    "Fitness, no difference: the 90 % t interval of the paired differences over grid cells (jobs that agree in all "
    "other "
    "parameters) lies within 5 % of the mean expected total either way, ±6.97 on the published grid (two one-sided "
    "tests at 5 %).";

using MaybeRow = std::optional<std::size_t>;

Part equivalent_fitness(const Rows& rows, MaybeRow row, std::string name, const std::string& sql) {
  Part part = part_of(std::move(name), "within ±5 %", equivalence_of_fitness, sql);
  if (!row) return part;
  const double margin = margin_share * std::fabs(rows.number(*row, "expected").value_or(0));
  part.expectation = "within ±" + figure(margin, 3);
  for (const auto& column : fitness_columns) {
    const auto interval = mean_interval(sample_in(rows, *row, column), equivalence_confidence);
    part.measured.push_back(within(column, interval, margin));
  }
  return part;
}

Part greater_fitness(const Rows& rows, MaybeRow row, std::string name, const std::string& sql) {
  Part part = part_of(std::move(name), "above 0", std::string("Fitness: ") + paired_above_0, sql);
  if (!row) return part;
  for (const auto& column : fitness_columns) {
    part.measured.push_back(above(column, mean_interval(sample_in(rows, *row, column), confidence), 0));
  }
  return part;
}

std::string pair_name(const std::string& of, std::string_view difference) {
  return of + ": " + std::string(difference);
}

}  // namespace

std::vector<Part> assess_normal_against_uniform(const Evidence& evidence, const Reading& reading) {
  const auto sql = pairing_sql(reading, {.kept = {"mutation", "acceptance"},
                                         .first = "steps = 'normal'",
                                         .second = "steps = 'uniform'",
                                         .differing = {"steps"}});
  const auto rows = evidence.query(sql);
  std::vector<Part> fitness;
  std::vector<Part> success;
  for (const std::string mutation : mutations) {
    for (const std::string acceptance : acceptances) {
      const auto row = find_row(rows, {{"mutation", mutation}, {"acceptance", acceptance}});
      const std::string of = mutation + ", " + acceptance;
      fitness.push_back(equivalent_fitness(rows, row, pair_name(of, "normal - uniform"), sql));
      success.push_back(part_of(pair_name(of, "rate, normal - uniform"), "within ±5 %",
                                "Success rate, no difference: the same, within 5 % of the mean rate of both.", sql));
      if (!row) continue;
      const double margin = 100 * margin_share * rows.number(*row, "success_level").value_or(0);
      success.back().unit = "%";
      success.back().expectation = "within ±" + figure(margin, 3);
      const auto interval = in_per_cent(mean_interval(sample_in(rows, *row, "success_rate"), equivalence_confidence));
      success.back().measured.push_back(within("success_rate", interval, margin));
    }
  }
  fitness.insert(fitness.end(), success.begin(), success.end());
  return fitness;
}

namespace {

/// How near the mean total of mutate-all comes to the expected one, in per cent of it, per condition of acceptance.
std::vector<Part> expected_reached(const Evidence& evidence, const Reading& reading) {
  const auto sql = averages_sql(reading, {"acceptance"}, "mutation = 'all' AND " + std::string(either_steps));
  const auto rows = evidence.query(sql);
  std::vector<Part> parts;
  for (const std::string acceptance : acceptances) {
    const bool annealing = acceptance == "annealing";
    parts.push_back(part_of(
        "all, " + acceptance + ": total, % of expected", annealing ? "above 95 %" : "below 95 %",
        "Expected fitness nearly reached: the mean total is at least 95 % of the mean expected total; its 95 % t "
        "interval lies above that with annealing, and below it with simple acceptance.",
        sql));
    parts.back().unit = "%";
    const auto row = find_row(rows, {{"acceptance", acceptance}});
    if (!row) continue;
    const double expected = rows.number(*row, "expected").value_or(0);
    for (const auto& column : fitness_columns) {
      auto interval = mean_interval(sample_in(rows, *row, column + "_reached"), confidence);
      if (interval && expected > 0) {
        for (double* value : {&interval->estimate, &interval->low, &interval->high})
          *value = 100 + 100 * *value / expected;
      }
      const double nearly = 100 - 100 * margin_share;
      parts.back().measured.push_back(annealing ? above(column, interval, nearly) : below(column, interval, nearly));
    }
  }
  return parts;
}

}  // namespace

std::vector<Part> assess_annealing_against_simple(const Evidence& evidence, const Reading& reading) {
  const auto sql = pairing_sql(reading, {.kept = {"mutation"},
                                         .first = "acceptance = 'annealing'",
                                         .second = "acceptance = 'simple'",
                                         .differing = {"acceptance"},
                                         .among = either_steps});
  const auto rows = evidence.query(sql);
  std::vector<Part> parts;
  for (const std::string mutation : mutations) {
    const auto row = find_row(rows, {{"mutation", mutation}});
    parts.push_back(greater_fitness(rows, row, pair_name(mutation, "annealing - simple"), sql));
  }
  for (const std::string mutation : mutations) {
    const auto row = find_row(rows, {{"mutation", mutation}});
    parts.push_back(part_of(pair_name(mutation, "rate, annealing - simple"), "above 0",
                            std::string("Success rate: ") + paired_above_0, sql));
    if (!row) continue;
    parts.back().unit = "%";
    const auto interval = in_per_cent(mean_interval(sample_in(rows, *row, "success_rate"), confidence));
    parts.back().measured.push_back(above("success_rate", interval, 0));
  }
  for (auto& part : expected_reached(evidence, reading)) parts.push_back(std::move(part));
  return parts;
}

std::vector<Part> assess_one_against_all(const Evidence& evidence, const Reading& reading) {
  const auto compare = [&](const std::string& first, const std::string& second, const std::string& among,
                           std::string name) {
    const auto sql = pairing_sql(reading, {.kept = {},
                                           .first = "mutation = '" + first + "'",
                                           .second = "mutation = '" + second + "'",
                                           .differing = {"mutation"},
                                           .among = among});
    const auto rows = evidence.query(sql);
    const bool has_cells = !rows.empty() && rows.number(0, "n").value_or(0) > 0;
    return greater_fitness(rows, has_cells ? MaybeRow(0) : std::nullopt, std::move(name), sql);
  };
  const std::string among = either_steps;
  return {compare("one", "all", among + " AND acceptance = 'annealing'", "annealing: one - all"),
          compare("all", "one", among, "overall: all - one")};
}

std::vector<Part> assess_some(const Evidence& evidence, const Reading& reading) {
  const auto sql = averages_sql(reading, {"mutation"}, either_steps);
  const auto rows = evidence.query(sql);
  const auto some = find_row(rows, {{"mutation", "some"}});
  std::vector<Part> parts;
  for (const std::string other : {"all", "one"}) {
    parts.push_back(part_of("overall: some - " + other, "below 0",
                            "Overall: Welch's 95 % interval of the difference of the means over all jobs (normal and "
                            "uniform, simple and annealing) lies below 0.",
                            sql));
    const auto row = find_row(rows, {{"mutation", other}});
    if (!row || !some) continue;
    for (const auto& column : fitness_columns) {
      parts.back().measured.push_back(
          below(column, welch_interval(sample_in(rows, *some, column), sample_in(rows, *row, column), confidence), 0));
    }
  }
  for (const std::string other : {"all", "one"}) {
    const auto paired = pairing_sql(
        reading, {.kept = {},
                  .first = "mutation = 'some'",
                  .second = "mutation = '" + other + "'",
                  .differing = {"mutation", "system_disturbance"},
                  .among = std::string(either_steps) + " AND (mutation = 'some' OR system_disturbance = 100)"});
    const auto cells = evidence.query(paired);
    parts.push_back(part_of("all disturbed: some - " + other, "below 0",
                            "All children disturbed (shown beside, judges nothing): the same against the cells of "
                            "100 % system disturbance only, paired, since mutate-some always starts there.",
                            paired));
    parts.back().decisive = false;
    if (cells.empty() || cells.number(0, "n").value_or(0) == 0) continue;
    for (const auto& column : fitness_columns) {
      parts.back().measured.push_back(below(column, mean_interval(sample_in(cells, 0, column), confidence), 0));
    }
  }
  return parts;
}

std::vector<Part> assess_one_fifth_rule(const Evidence& evidence, const Reading& reading) {
  std::vector<Part> parts;
  for (const std::string other : {"normal", "uniform"}) {
    const auto sql = pairing_sql(reading, {.kept = {"mutation", "acceptance"},
                                           .first = "steps = 'one_fifth_rule'",
                                           .second = "steps = '" + other + "'",
                                           .differing = {"steps", "mutation_size"}});
    const auto rows = evidence.query(sql);
    for (const std::string mutation : mutations) {
      for (const std::string acceptance : acceptances) {
        const auto row = find_row(rows, {{"mutation", mutation}, {"acceptance", acceptance}});
        parts.push_back(
            equivalent_fitness(rows, row, pair_name(mutation + ", " + acceptance, "1/5 rule - " + other), sql));
        parts.back().rule += " The 1/5 rule has no mutation size: its cells are compared with the mean over all sizes.";
      }
    }
  }
  return parts;
}

}  // namespace lamprey::client::report
