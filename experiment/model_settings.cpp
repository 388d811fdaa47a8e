#include "experiment/model_settings.hpp"

namespace lamprey::experiment {

namespace {

using namespace science;
using namespace science::evolution;
using actuators::Actuator;
using actuators::ActuatorPath;
using gaits::Gait;
using operators::Crossover;
using operators::Selection;
using trainers::StepSizes;
using trainers::Strategy;

constexpr std::array mutations{Choice<MutationTechnique>{"all", MutationTechnique::all},
                               Choice<MutationTechnique>{"one", MutationTechnique::one},
                               Choice<MutationTechnique>{"some", MutationTechnique::some}};
constexpr std::array steps{Choice<Steps>{"uniform", Steps::uniform}, Choice<Steps>{"normal", Steps::normal},
                           Choice<Steps>{"one_fifth_rule", Steps::one_fifth_rule}};
constexpr std::array acceptances{Choice<Acceptance>{"simple", Acceptance::simple},
                                 Choice<Acceptance>{"annealing", Acceptance::annealing}};
constexpr std::array criteria{Choice<Criterion>{"per_component", Criterion::per_component},
                              Choice<Criterion>{"total", Criterion::total}};
constexpr std::array postures{Choice<Posture>{"reset", Posture::reset}, Choice<Posture>{"carry", Posture::carry}};
constexpr std::array variances{Choice<StepVariance>{"constant", StepVariance::constant},
                               Choice<StepVariance>{"root_error", StepVariance::root_error}};

constexpr std::array neurons{Choice<problems::BipedNeuron>{"threshold", problems::BipedNeuron::threshold},
                             Choice<problems::BipedNeuron>{"acting_output", problems::BipedNeuron::acting_output},
                             Choice<problems::BipedNeuron>{"net_as_on_time", problems::BipedNeuron::net_as_on_time},
                             Choice<problems::BipedNeuron>{"mcculloch_pitts", problems::BipedNeuron::mcculloch_pitts},
                             Choice<problems::BipedNeuron>{"timed", problems::BipedNeuron::timed}};
constexpr std::array weight_ranges{Choice<problems::BipedWeights>{"as_printed", problems::BipedWeights::as_printed},
                                   Choice<problems::BipedWeights>{"either_sign", problems::BipedWeights::either_sign}};
constexpr std::array gaits_known{Choice<Gait>{"walk", Gait::walk},   Choice<Gait>{"trot", Gait::trot},
                                 Choice<Gait>{"pace", Gait::pace},   Choice<Gait>{"gallop", Gait::gallop},
                                 Choice<Gait>{"pronk", Gait::pronk}, Choice<Gait>{"walk_frames", Gait::walk_frames}};
constexpr std::array yes_or_no{Choice<bool>{"yes", true}, Choice<bool>{"no", false}};
constexpr std::array tonic_genes{
    Choice<problems::TonicGenes>{"tonic", problems::TonicGenes::tonic},
    Choice<problems::TonicGenes>{"tonic_and_weights", problems::TonicGenes::tonic_and_weights}};
constexpr std::array paths{Choice<ActuatorPath>{"unit_move", ActuatorPath::unit_move},
                           Choice<ActuatorPath>{"leaky_chain", ActuatorPath::leaky_chain}};
constexpr std::array selections{Choice<Selection>{"truncation", Selection::truncation},
                                Choice<Selection>{"roulette", Selection::roulette},
                                Choice<Selection>{"tournament", Selection::tournament}};
constexpr std::array crossovers{
    Choice<Crossover>{"one_point", Crossover::one_point}, Choice<Crossover>{"two_point", Crossover::two_point},
    Choice<Crossover>{"blend", Crossover::blend}, Choice<Crossover>{"michalewicz", Crossover::michalewicz},
    Choice<Crossover>{"blx_alpha", Crossover::blx_alpha}};
constexpr std::array strategies{Choice<Strategy>{"one_plus_one", Strategy::one_plus_one},
                                Choice<Strategy>{"mu_plus_one", Strategy::mu_plus_one},
                                Choice<Strategy>{"mu_plus_lambda", Strategy::mu_plus_lambda},
                                Choice<Strategy>{"mu_comma_lambda", Strategy::mu_comma_lambda}};

Actuator actuator_settings(const Parameters& parameters) {
  return {.path = choose(parameters, "actuator", paths),
          .integrator = {parameters.real("integrator_time_constant")},
          .stroke = parameters.real("actuator_stroke"),
          .reflex = {parameters.real("reflex_gain"), parameters.real("reflex_damping")}};
}

std::int32_t time_steps_of(const Parameters& parameters) {
  return static_cast<std::int32_t>(parameters.integer("time_steps"));
}

Posture posture_setting(const Parameters& parameters) {
  return choose(parameters, "posture", postures);
}

/// The largest step is the registry's: a first step above the usual bound must not be refused.
StepSizes step_sizes(const Parameters& parameters) {
  const double first = parameters.real("first_step");
  const StepSizes usual;
  return {.first = first, .smallest = std::min(first, usual.smallest), .largest = std::max(first, usual.largest)};
}

}  // namespace

std::invalid_argument no_model_of(std::string_view parameter, std::string_view value) {
  return std::invalid_argument(std::string(parameter) + " is \"" + std::string(value) +
                               "\", of which there is no model");
}

RteaSettings rtea_settings(const Parameters& parameters) {
  return {
      .mutation = mutation_setting(parameters),
      .steps = choose(parameters, "steps", steps),
      .size = size_of_percent(parameters.integer("mutation_size")),
      .step_variance = choose(parameters, "step_variance", variances),
      .one_fifth_rule = {.first_standard_deviation = parameters.real("first_standard_deviation"),
                         .window = count_of(parameters, "success_window"),
                         .factor = parameters.real("standard_deviation_factor"),
                         .minimum_standard_deviation = parameters.real("minimum_standard_deviation"),
                         .maximum_standard_deviation = parameters.real("maximum_standard_deviation")},
      .criterion = choose(parameters, "criterion", criteria),
      .acceptance = choose(parameters, "acceptance", acceptances),
      .temperature = parameters.real("temperature"),
      .cooling = parameters.real("cooling"),
      .posture = posture_setting(parameters),
  };
}

Disturbance disturbance_settings(const Parameters& parameters) {
  // 8.3: mutate-some has no system disturbance; all the neurons are disturbed.
  const bool applies = parameters.applies(parameter_index("system_disturbance"));
  return {.size = size_of_percent(parameters.integer("equilibrium_disturbance")),
          .percent = applies ? parameters.integer("system_disturbance") : 100};
}

MutationTechnique mutation_setting(const Parameters& parameters) {
  return choose(parameters, "mutation", mutations);
}

problems::QuadrupedSettings quadruped_settings(const Parameters& parameters, problems::QuadrupedNetwork network) {
  return {.network = network,
          .gait = choose(parameters, "gait", gaits_known),
          .actuator = actuator_settings(parameters),
          .time_steps = time_steps_of(parameters),
          .delay_refirings = choose(parameters, "delay_refirings", yes_or_no),
          .tonic_genes = choose(parameters, "tonic_genes", tonic_genes)};
}

problems::BipedSettings biped_settings(const Parameters& parameters, problems::BipedNetwork network) {
  return {.network = network,
          .neuron = choose(parameters, "neuron", neurons),
          .weights = choose(parameters, "weight_range", weight_ranges),
          .actuator = actuator_settings(parameters),
          .time_steps = time_steps_of(parameters)};
}

trainers::IiRteaSettings ii_rtea_settings(const Parameters& parameters) {
  return {.mutation_rate = parameters.real("mutation_rate"), .posture = posture_setting(parameters), .first_genes = {}};
}

trainers::ChapterSixGaSettings chapter_six_ga_settings(const Parameters& parameters) {
  return {.mutation_rate = parameters.real("mutation_rate"), .first_genes = {}};
}

trainers::GeneticAlgorithmSettings genetic_algorithm_settings(const Parameters& parameters) {
  return {.population = count_of(parameters, "population"),
          .selection = choose(parameters, "selection", selections),
          .tournament_size = count_of(parameters, "tournament_size"),
          .crossover = choose(parameters, "crossover", crossovers),
          .blend_alpha = parameters.real("blend_alpha"),
          .mutation_rate = parameters.real("mutation_rate"),
          .first_genes = {}};
}

trainers::SimulatedAnnealingSettings simulated_annealing_settings(const Parameters& parameters) {
  return {.first_step = parameters.real("first_step"),
          .first_temperature = parameters.real("first_temperature"),
          .temperature_factor = parameters.real("temperature_factor"),
          .first_genes = {}};
}

trainers::EvolutionStrategySettings evolution_strategy_settings(const Parameters& parameters) {
  return {.strategy = choose(parameters, "strategy", strategies),
          .population = count_of(parameters, "population"),
          .offspring = count_of(parameters, "offspring"),
          .steps = step_sizes(parameters),
          .first_genes = {}};
}

trainers::EvolutionaryProgrammingSettings evolutionary_programming_settings(const Parameters& parameters) {
  return {.population = count_of(parameters, "population"), .steps = step_sizes(parameters), .first_genes = {}};
}

yardsticks::PagmoSgaSettings pagmo_sga_settings(const Parameters& parameters) {
  return {.population = count_of(parameters, "population"), .first_genes = {}};
}

yardsticks::PagmoSimulatedAnnealingSettings pagmo_simulated_annealing_settings(const Parameters& parameters) {
  return {.planned_evaluations = count_of(parameters, "cycles"), .first_genes = {}};
}

yardsticks::PagmoCmaesSettings pagmo_cmaes_settings(const Parameters& parameters) {
  return {.population = count_of(parameters, "population"), .first_genes = {}};
}

}  // namespace lamprey::experiment
