#include "experiment/outcome_recorder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

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

// The measures that the recorder adds before the end. Their places in the list are part of the checkpoint's format.
constexpr std::string_view recovered = "recovered";
constexpr std::string_view recovery_cycles = "recovery_cycles";
constexpr std::string_view environment_expected_total = "environment_expected_total";
constexpr std::string_view parameter_variation = "parameter_variation";
constexpr std::array running_measures{recovered, recovery_cycles, environment_expected_total, parameter_variation};

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
  if (recovery_.pending) add_measure(recovered, changes_ - 1, 0);
  start_anew(training, retried);
  best_total_ = outcome_.highest.total;
  recovery_ = {.first_cycle = outcome_.cycles, .pending = true};
  add_measure(environment_expected_total, changes_, outcome_.expected.total);
  ++changes_;
  note_recovery(outcome_.final);
}

void OutcomeRecorder::note_recovery(const Score& score) {
  if (!recovery_.pending || !is_recovered(score.total, outcome_.expected.total)) return;
  recovery_.pending = false;
  add_measure(recovered, changes_ - 1, 1);
  add_measure(recovery_cycles, changes_ - 1, outcome_.cycles - recovery_.first_cycle);
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
  add_measure(parameter_variation, outcome_.trace.back().cycle, sum / static_cast<double>(genes.size()));
}

void OutcomeRecorder::add_measure(std::string_view name, std::uint32_t index, double value) {
  outcome_.measures.push_back({.name = std::string(name), .index = index, .value = unsigned_zero(value)});
}

void OutcomeRecorder::finish(std::span<const evolution::Measure> measures) {
  if (recovery_.pending) add_measure(recovered, changes_ - 1, 0);
  if (outcome_.cycles > 0) outcome_.success_rate = static_cast<double>(outcome_.successes) / outcome_.cycles;
  if (details_ && outcome_.cycles > 0) {
    add_measure("on_line_performance", 0, sum_of_totals_ / outcome_.cycles);
    add_measure("off_line_performance", 0, sum_of_best_totals_ / outcome_.cycles);
  }
  for (const auto& measure : measures) add_measure(measure.name, measure.index, measure.value);
  std::ranges::sort(outcome_.measures, {}, [](const Measure& m) { return std::tie(m.name, m.index); });
}

namespace {

void score_fields(auto& archive, saving::Of<Score> auto& score) {
  archive.real("stability", score.stability);
  archive.real("distance", score.distance);
  archive.real("fuel", score.fuel);
  archive.real("total", score.total);
}

void measure_fields(auto& archive, std::uint32_t largest_index, saving::Of<Measure> auto& measure) {
  auto place = static_cast<std::uint8_t>(std::ranges::find(running_measures, measure.name) - running_measures.begin());
  archive.whole("measure", place, 0, std::uint8_t{running_measures.size() - 1});
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(measure)>>) measure.name = running_measures[place];
  archive.whole("index of a measure", measure.index, 0, largest_index);
  archive.real("value of a measure", measure.value);
}

}  // namespace

// What is not here the training and the trace give: what is expected, and how many changes were accepted.
template <typename Archive, typename Recorder>
void OutcomeRecorder::fields(Archive& archive, const evolution::Training& training, Recorder& recorder) {
  auto& outcome = recorder.outcome_;
  for (auto* score : {&outcome.initial, &outcome.evolved, &outcome.highest, &outcome.final}) {
    score_fields(archive, *score);
  }
  archive.whole("successes", outcome.successes, 0, outcome.cycles);
  archive.real("evolved_error", recorder.evolved_error_);
  archive.whole("cycle of the latest change", recorder.recovery_.first_cycle, 0, outcome.cycles);
  archive.flag("recovery pending", recorder.recovery_.pending);
  if (recorder.details_) {
    evolution::fields(archive, training.problem.plan(), recorder.first_genes_);
    archive.real("sum_of_totals", recorder.sum_of_totals_);
    archive.real("sum_of_best_totals", recorder.sum_of_best_totals_);
    archive.real("best_total", recorder.best_total_);
  }
}

void OutcomeRecorder::save(const evolution::Training& training, saving::Writer& writer) const {
  fields(writer, training, *this);
  const auto measures = static_cast<std::uint32_t>(outcome_.measures.size());
  writer.whole("measures", measures, 0, measures);
  for (const Measure& measure : outcome_.measures) measure_fields(writer, outcome_.cycles, measure);
}

void OutcomeRecorder::restore(const evolution::Training& training, std::uint32_t cycles, std::uint32_t changes,
                              std::vector<AcceptedChange> trace, saving::Reader& reader) {
  outcome_.cycles = cycles;
  outcome_.accepted = static_cast<std::uint32_t>(trace.size());
  outcome_.trace = std::move(trace);
  outcome_.expected = scored(training.expected, training.environment.weights);
  changes_ = changes;
  fields(reader, training, *this);
  if (recovery_.pending && changes_ == 0) throw saving::Invalid("recovery is pending, but nothing has changed");
  std::uint32_t measures = 0;
  reader.whole("measures", measures, 0, std::numeric_limits<std::uint32_t>::max());
  for (std::uint32_t i = 0; i < measures; ++i) measure_fields(reader, cycles, outcome_.measures.emplace_back());
}

}  // namespace lamprey::experiment
