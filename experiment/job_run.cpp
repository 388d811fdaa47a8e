#include "experiment/job_run.hpp"

#include "science/gaits/walk.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace lamprey::experiment {

namespace {

using namespace science;

template <typename Meaning>
using Choice = std::pair<std::string_view, Meaning>;

template <typename Meaning, std::size_t Count>
Meaning choose(const Parameters& parameters, std::string_view name, const std::array<Choice<Meaning>, Count>& choices) {
  const std::string& value = parameters.choice(name);
  for (const auto& [known, meaning] : choices) {
    if (known == value) return meaning;
  }
  throw std::invalid_argument(std::string(name) + " is \"" + value + "\", of which there is no model");
}

using Gait = networks::FourMotherNetwork (*)();

constexpr std::array robots{Choice<bool>{"quadruped", true}};
constexpr std::array networks_of_robots{Choice<bool>{"four_mother", true}};
constexpr std::array gaits_of_networks{Choice<Gait>{"walk", gaits::walk}};
constexpr std::array mutations{Choice<evolution::MutationTechnique>{"all", evolution::MutationTechnique::all},
                               Choice<evolution::MutationTechnique>{"one", evolution::MutationTechnique::one},
                               Choice<evolution::MutationTechnique>{"some", evolution::MutationTechnique::some}};
constexpr std::array steps{Choice<evolution::Steps>{"uniform", evolution::Steps::uniform},
                           Choice<evolution::Steps>{"normal", evolution::Steps::normal},
                           Choice<evolution::Steps>{"one_fifth_rule", evolution::Steps::one_fifth_rule}};
constexpr std::array acceptances{Choice<evolution::Acceptance>{"simple", evolution::Acceptance::simple},
                                 Choice<evolution::Acceptance>{"annealing", evolution::Acceptance::annealing}};
constexpr std::array objectives{Choice<evolution::Objective>{"target", evolution::Objective::target},
                                Choice<evolution::Objective>{"maximise", evolution::Objective::maximise}};
constexpr std::array criteria{Choice<evolution::Criterion>{"per_component", evolution::Criterion::per_component},
                              Choice<evolution::Criterion>{"total", evolution::Criterion::total}};
constexpr std::array postures{Choice<evolution::Posture>{"reset", evolution::Posture::reset},
                              Choice<evolution::Posture>{"carry", evolution::Posture::carry}};
constexpr std::array variances{Choice<evolution::StepVariance>{"constant", evolution::StepVariance::constant},
                               Choice<evolution::StepVariance>{"root_error", evolution::StepVariance::root_error}};

std::uint32_t count_of(const Parameters& parameters, std::string_view name) {
  return static_cast<std::uint32_t>(parameters.integer(name));
}

double share_of(const Parameters& parameters, std::string_view name) {
  return static_cast<double>(parameters.integer(name)) / 100;
}

evolution::Rtea rtea_settings(const Parameters& parameters) {
  return {
      .mutation = choose(parameters, "mutation", mutations),
      .steps = choose(parameters, "steps", steps),
      .size = evolution::size_of_percent(parameters.integer("mutation_size")),
      .step_variance = choose(parameters, "step_variance", variances),
      .one_fifth_rule = {.first_standard_deviation = parameters.real("first_standard_deviation"),
                         .window = count_of(parameters, "success_window"),
                         .factor = parameters.real("standard_deviation_factor"),
                         .minimum_standard_deviation = parameters.real("minimum_standard_deviation"),
                         .maximum_standard_deviation = parameters.real("maximum_standard_deviation")},
      .objective = choose(parameters, "objective", objectives),
      .criterion = choose(parameters, "criterion", criteria),
      .acceptance = choose(parameters, "acceptance", acceptances),
      .temperature = parameters.real("temperature"),
      .cooling = parameters.real("cooling"),
      .posture = choose(parameters, "posture", postures),
      .weights = {.stability = share_of(parameters, "required_stability"),
                  .distance = share_of(parameters, "required_distance"),
                  .fuel = share_of(parameters, "required_fuel")},
  };
}

Score scored(const fitness::Fitness& fitness, const fitness::Weights& weights) {
  return {.stability = fitness.stability,
          .distance = fitness.distance,
          .fuel = fitness.fuel,
          .total = fitness::total(fitness, weights)};
}

double distance_from_expected(const JobSettings& settings, const JobState& state, const fitness::Fitness& fitness) {
  return evolution::total(
      evolution::errors(evolution::Objective::target, settings.rtea.weights, state.expected, fitness));
}

/// Between two looks at the stop token: short enough to stop at once, long enough to cost nothing.
constexpr std::uint32_t cycles_between_looks = 64;

}  // namespace

JobSettings job_settings(const Parameters& parameters) {
  choose(parameters, "robot", robots);
  choose(parameters, "network", networks_of_robots);

  JobSettings settings;
  settings.trial.time_steps = static_cast<std::int32_t>(parameters.integer("time_steps"));
  settings.gait = choose(parameters, "gait", gaits_of_networks)();
  settings.rtea = rtea_settings(parameters);
  settings.cycles = count_of(parameters, "cycles");
  // 8.3: mutate-some has no system disturbance; all the neurons are disturbed.
  const bool all_disturbed = settings.rtea.mutation == evolution::MutationTechnique::some;
  const std::int64_t disturbed_percent = all_disturbed ? 100 : parameters.integer("system_disturbance");
  settings.disturbance = {.size = evolution::size_of_percent(parameters.integer("equilibrium_disturbance")),
                          .per_kind = evolution::disturbed_per_kind(disturbed_percent)};
  return settings;
}

JobState begin_job(const JobSettings& settings, const random::Stream& stream) {
  using Trial = fitness::QuadrupedTrial;
  const fitness::Weights& weights = settings.rtea.weights;
  JobState state;
  Trial::Body standing;
  state.expected = settings.trial.evaluate(settings.gait, standing);

  networks::FourMotherNetwork disturbed = settings.gait;
  evolution::disturb(stream, settings.disturbance, {networks::vertical_children, networks::horizontal_children},
                     evolution::gene_plan<Trial>(), Trial::units(disturbed));
  state.rtea = evolution::begin(settings.rtea, settings.trial, disturbed);

  Outcome& outcome = state.outcome;
  outcome.expected = scored(state.expected, weights);
  outcome.initial = scored(state.rtea.fitness, weights);
  outcome.evolved = outcome.highest = outcome.final = outcome.initial;
  state.evolved_error = distance_from_expected(settings, state, state.rtea.fitness);
  return state;
}

void advance_job(const JobSettings& settings, const random::Stream& stream, JobState& state, std::uint32_t cycles) {
  Outcome& outcome = state.outcome;
  const std::uint32_t end = outcome.cycles + std::min(cycles, settings.cycles - outcome.cycles);
  while (outcome.cycles < end) {
    const std::uint32_t cycle = outcome.cycles++;
    const evolution::CycleReport report =
        evolution::advance(settings.rtea, settings.trial, state.expected, stream, state.rtea);
    outcome.successes += report.success;
    if (!report.accepted) continue;

    const Score score = scored(report.fitness, settings.rtea.weights);
    ++outcome.accepted;
    outcome.trace.push_back({.cycle = cycle, .score = score});
    outcome.final = score;
    if (score.total > outcome.highest.total) outcome.highest = score;
    const double error = distance_from_expected(settings, state, report.fitness);
    if (error < state.evolved_error) {
      state.evolved_error = error;
      outcome.evolved = score;
    }
  }
  if (outcome.cycles == settings.cycles && outcome.cycles > 0) {
    outcome.success_rate = static_cast<double>(outcome.successes) / outcome.cycles;
  }
}

std::variant<Outcome, Interrupted> run_job(const Job& job, const std::stop_token& stop) {
  const JobSettings settings = job_settings(job.parameters);
  const random::Stream stream(stream_key(job));
  if (stop.stop_requested()) return Interrupted{};
  JobState state = begin_job(settings, stream);
  while (state.outcome.cycles < settings.cycles) {
    if (stop.stop_requested()) return Interrupted{};
    advance_job(settings, stream, state, cycles_between_looks);
  }
  return std::move(state.outcome);
}

Score evaluate_preset(const Parameters& parameters) {
  const JobSettings settings = job_settings(parameters);
  fitness::QuadrupedTrial::Body standing;
  return scored(settings.trial.evaluate(settings.gait, standing), settings.rtea.weights);
}

}  // namespace lamprey::experiment
