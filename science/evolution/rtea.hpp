#pragma once

#include "science/evolution/acceptance.hpp"
#include "science/evolution/mutation.hpp"
#include "science/evolution/objective.hpp"
#include "science/evolution/step_size.hpp"
#include "science/fitness/quadruped_fitness.hpp"
#include "science/random/stream.hpp"

#include <concepts>
#include <cstdint>
#include <span>

namespace lamprey::science::evolution {

// The real-time evolutionary algorithm of chapter 4 (fig. 4.1): a population of one, no recombination; mutate, run,
// compare, accept or restore; for ever.

/// What the algorithm can tune: a genome of units, tried with a body. A default Body stands and has clocks at zero.
template <class T>
concept Trial = requires(const T& trial, typename T::Genome& genome, typename T::Body& body) {
  { trial.evaluate(genome, body) } -> std::same_as<fitness::Fitness>;
  { T::units(genome) } -> std::convertible_to<std::span<Unit>>;
  { T::symmetric_units } -> std::convertible_to<std::span<const std::array<std::uint8_t, 4>>>;
  { T::minimum_gene } -> std::convertible_to<double>;
  { T::maximum_gene } -> std::convertible_to<double>;
};

template <Trial T>
GenePlan gene_plan() {
  return {.minimum = T::minimum_gene, .maximum = T::maximum_gene, .symmetric_units = T::symmetric_units};
}

/// 4.2.3 and 4.2.4: what steps are drawn from.
enum class Steps : std::uint8_t { uniform, normal, one_fifth_rule };

/// Between evaluations: stand up and begin anew, or walk on as a physical robot must (appendix C sets it up once).
/// Under `carry` the robot's posture, the mothers' clocks and pending windows live on, also through rejected
/// candidates; the parent is not tried again, and a pending window meets its new times at once.
enum class Posture : std::uint8_t { reset, carry };

struct Rtea {
  MutationTechnique mutation = MutationTechnique::all;
  Steps steps = Steps::uniform;
  int size = 5;                                         ///< uniform: steps in ±size; normal: standard deviation size/2
  StepVariance step_variance = StepVariance::constant;  ///< of normal steps under `target`; else not used
  OneFifthRule one_fifth_rule{};
  Objective objective = Objective::target;
  Criterion criterion = Criterion::per_component;
  Acceptance acceptance = Acceptance::simple;
  double temperature = 1;  ///< of the first cycle, ≥ 0
  double cooling = 1;      ///< the temperature is multiplied by it after each cycle; 1 keeps it
  Posture posture = Posture::reset;
  fitness::Weights weights{};
};

/// Everything that the algorithm carries from one cycle to the next: with the settings and the stream it decides all
/// that follows.
template <Trial T>
struct RteaState {
  std::uint32_t cycle = 0;      ///< the number of cycles done, and the next one's number
  typename T::Genome genome{};  ///< last accepted
  fitness::Fitness fitness;     ///< of the last accepted, when it was tried
  typename T::Body body{};      ///< where the last evaluation ended, accepted or not
  OneFifthState one_fifth;
  double temperature = 0;
};

/// What one cycle did.
struct CycleReport {
  fitness::Fitness fitness;  ///< of the candidate
  bool accepted = false;
  bool success = false;  ///< the criterion calls it better than the last accepted state (eq. 8.1)
};

/// Tries the first genome once from standing; no cycle is counted.
template <Trial T>
RteaState<T> begin(const Rtea& rtea, const T& trial, const typename T::Genome& genome) {
  RteaState<T> state;
  state.genome = genome;
  state.fitness = trial.evaluate(genome, state.body);
  state.one_fifth = first_state(rtea.one_fifth_rule);
  state.temperature = rtea.temperature;
  return state;
}

/// What the next cycle's steps are drawn from; `last_accepted` are the errors of the last accepted state.
StepDistribution step_distribution(const Rtea& rtea, const OneFifthState& one_fifth, const Errors& last_accepted);

/// One cycle. `expected` is what `target` aims at.
template <Trial T>
CycleReport advance(const Rtea& rtea, const T& trial, const fitness::Fitness& expected, const random::Stream& stream,
                    RteaState<T>& state) {
  const Errors before = errors(rtea.objective, rtea.weights, expected, state.fitness);
  typename T::Genome candidate = state.genome;
  mutate(stream, state.cycle, rtea.mutation, step_distribution(rtea, state.one_fifth, before), gene_plan<T>(),
         T::units(candidate));

  if (rtea.posture == Posture::reset) state.body = {};
  CycleReport report{.fitness = trial.evaluate(candidate, state.body)};
  const Errors now = errors(rtea.objective, rtea.weights, expected, report.fitness);

  const Comparison comparison = compare(rtea.criterion, now, before);
  report.success = comparison.better;
  report.accepted = comparison.acceptable;
  if (rtea.acceptance == Acceptance::annealing && !report.accepted) {
    const auto words = stream.block(state.cycle, random::Purpose::acceptance, 0);
    report.accepted =
        metropolis_accepts(total(now) - total(before), state.temperature, random::unit_interval(words[0], words[1]));
  }
  if (report.accepted) {
    state.genome = candidate;
    state.fitness = report.fitness;
  }
  record(rtea.one_fifth_rule, state.one_fifth, report.success);
  state.temperature *= rtea.cooling;
  ++state.cycle;
  return report;
}

}  // namespace lamprey::science::evolution
