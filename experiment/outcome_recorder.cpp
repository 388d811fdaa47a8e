#include "experiment/outcome_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

namespace lamprey::experiment {

namespace {

using namespace science;

double distance_from_expected(const evolution::Training& training, const fitness::Fitness& fitness) {
  return evolution::total(
      evolution::errors(evolution::Objective::target, training.environment.weights, training.expected, fitness));
}

/// Recovered is what comes within a twentieth of the expected total (95 % of it where it is positive).
bool is_recovered(double total, double expected) {
  constexpr double tolerated_share = 0.05;
  return total >= expected - tolerated_share * std::fabs(expected);
}

/// Zero is stored without a sign.
double unsigned_zero(double value) {
  return value == 0 ? 0.0 : value;
}

}  // namespace

Score scored(const fitness::Fitness& fitness, const fitness::Weights& weights) {
  return {.stability = fitness.stability,
          .distance = fitness.distance,
          .fuel = fitness.fuel,
          .total = fitness::total(fitness, weights)};
}

void OutcomeRecorder::begin(const evolution::Training& training, const fitness::Fitness& first,
                            std::span<const double> genes) {
  start_anew(training, first);
  outcome_.initial = outcome_.final;
  first_genes_.assign(genes.begin(), genes.end());
  best_total_ = outcome_.initial.total;
}

void OutcomeRecorder::start_anew(const evolution::Training& training, const fitness::Fitness& fitness) {
  const Score score = scored(fitness, training.environment.weights);
  outcome_.expected = scored(training.expected, training.environment.weights);
  outcome_.evolved = outcome_.highest = outcome_.final = score;
  evolved_error_ = distance_from_expected(training, fitness);
}

void OutcomeRecorder::change_environment(const evolution::Training& training, const fitness::Fitness& retried) {
  if (recovery_.pending) add_measure("recovered", changes_ - 1, 0);
  start_anew(training, retried);
  best_total_ = outcome_.highest.total;
  recovery_ = {.first_cycle = outcome_.cycles, .pending = true};
  add_measure("environment_expected_total", changes_, outcome_.expected.total);
  ++changes_;
  note_recovery(outcome_.final);
}

void OutcomeRecorder::note_recovery(const Score& score) {
  if (!recovery_.pending || !is_recovered(score.total, outcome_.expected.total)) return;
  recovery_.pending = false;
  add_measure("recovered", changes_ - 1, 1);
  add_measure("recovery_cycles", changes_ - 1, outcome_.cycles - recovery_.first_cycle);
}

void OutcomeRecorder::record(const evolution::Training& training, std::span<const evolution::CycleReport> reports,
                             std::span<const double> genes) {
  const std::uint32_t accepted = outcome_.accepted;
  for (const auto& report : reports) record_one(training, report);
  if (details_ && outcome_.accepted > accepted) note_variation(genes);
}

void OutcomeRecorder::record_one(const evolution::Training& training, const evolution::CycleReport& report) {
  ++outcome_.cycles;
  outcome_.successes += report.success;
  if (details_) {
    const double total = fitness::total(report.fitness, training.environment.weights);
    best_total_ = std::max(best_total_, total);
    sum_of_totals_ += total;
    sum_of_best_totals_ += best_total_;
  }
  if (!report.accepted) return;
  accept(training, report.fitness, scored(report.fitness, training.environment.weights));
}

void OutcomeRecorder::accept(const evolution::Training& training, const fitness::Fitness& fitness, const Score& score) {
  ++outcome_.accepted;
  outcome_.trace.push_back({.cycle = outcome_.cycles - 1, .score = score});
  outcome_.final = score;
  if (score.total > outcome_.highest.total) outcome_.highest = score;
  const double error = distance_from_expected(training, fitness);
  if (error < evolved_error_) {
    evolved_error_ = error;
    outcome_.evolved = score;
  }
  note_recovery(score);
}

void OutcomeRecorder::note_variation(std::span<const double> genes) {
  double sum = 0;
  for (std::size_t i = 0; i < genes.size(); ++i) sum += std::fabs(genes[i] - first_genes_[i]);
  add_measure("parameter_variation", outcome_.trace.back().cycle, sum / static_cast<double>(genes.size()));
}

void OutcomeRecorder::add_measure(std::string_view name, std::uint32_t index, double value) {
  outcome_.measures.push_back({.name = std::string(name), .index = index, .value = unsigned_zero(value)});
}

void OutcomeRecorder::finish(std::span<const evolution::Measure> measures) {
  if (recovery_.pending) add_measure("recovered", changes_ - 1, 0);
  if (outcome_.cycles > 0) outcome_.success_rate = static_cast<double>(outcome_.successes) / outcome_.cycles;
  if (details_ && outcome_.cycles > 0) {
    add_measure("on_line_performance", 0, sum_of_totals_ / outcome_.cycles);
    add_measure("off_line_performance", 0, sum_of_best_totals_ / outcome_.cycles);
  }
  for (const auto& measure : measures) add_measure(measure.name, measure.index, measure.value);
  std::ranges::sort(outcome_.measures, {}, [](const Measure& m) { return std::tie(m.name, m.index); });
}

}  // namespace lamprey::experiment
