#include "experiment/models.hpp"
#include "experiment/parameters.hpp"
#include "science/actuators/actuator.hpp"

namespace lamprey::experiment {

namespace {

/// The names of a table of models.
template <typename Model>
std::vector<std::string_view> names(std::span<const Model> models) {
  std::vector<std::string_view> result;
  for (const Model& model : models) result.push_back(model.name);
  return result;
}

/// A choice; the first name is the default.
Parameter choice(std::string_view name, std::string_view meaning, std::vector<std::string_view> choices,
                 std::string_view source, std::vector<Condition> applies_when = {}) {
  Value first = std::string(choices.front());
  return {.name = name,
          .meaning = meaning,
          .unit = "",
          .kind = ParameterKind::choice,
          .default_value = std::move(first),
          .choices = std::move(choices),
          .source = source,
          .applies_when = std::move(applies_when)};
}

struct IntegerRange {
  std::int64_t minimum;
  std::int64_t maximum;
  std::int64_t default_value;
  std::string_view unit = "";
};

Parameter integer(std::string_view name, std::string_view meaning, const IntegerRange& range, std::string_view source,
                  std::vector<Condition> applies_when = {}) {
  return {.name = name,
          .meaning = meaning,
          .unit = range.unit,
          .kind = ParameterKind::integer,
          .default_value = range.default_value,
          .minimum = static_cast<double>(range.minimum),
          .maximum = static_cast<double>(range.maximum),
          .choices = {},
          .source = source,
          .applies_when = std::move(applies_when)};
}

Parameter percent(std::string_view name, std::string_view meaning, std::int64_t default_value, std::string_view source,
                  std::vector<Condition> applies_when = {}) {
  return integer(name, meaning, {0, 100, default_value, "%"}, source, std::move(applies_when));
}

struct RealRange {
  double minimum;
  double maximum;
  double default_value;
  std::string_view unit = "";
};

Parameter real(std::string_view name, std::string_view meaning, const RealRange& range, std::string_view source,
               std::vector<Condition> applies_when) {
  return {.name = name,
          .meaning = meaning,
          .unit = range.unit,
          .kind = ParameterKind::real,
          .default_value = range.default_value,
          .minimum = range.minimum,
          .maximum = range.maximum,
          .choices = {},
          .source = source,
          .applies_when = std::move(applies_when)};
}

/// Changes of other parameters at given cycles; the default never changes any.
Parameter schedule(std::string_view name, std::string_view meaning, std::string_view source,
                   std::vector<Condition> applies_when) {
  return {.name = name,
          .meaning = meaning,
          .unit = "",
          .kind = ParameterKind::schedule,
          .default_value = std::string(),
          .choices = {},
          .source = source,
          .applies_when = std::move(applies_when)};
}

// Who has what. Conditions name choices of earlier rows.
Condition of_quadruped() {
  return {"robot", true, {"quadruped", "bridge"}};
}
/// A robot stands on the ground that is there.
Condition simulated() {
  return {"robot", true, {"quadruped"}};
}
Condition of_pairs() {
  return {"network", true, {"recurrent_pair", "feed_forward_pair"}};
}
Condition with_preset() {
  return {"network", false, {"recurrent_pair", "feed_forward_pair"}};
}
Condition not_tonic() {
  return {"network", false, {"tonic"}};
}
Condition of_tonic() {
  return {"network", true, {"tonic"}};
}
/// The frames of fig. 7.13 are compared as outputs: no robot stands on any ground.
Condition not_frames() {
  return {"gait", false, {"walk_frames"}};
}
Condition with_chain() {
  return {"actuator", true, {"leaky_chain"}};
}
Condition of_rtea() {
  return {"trainer", true, {"rtea", "hybrid"}};
}
Condition with_step_size() {
  return {"steps", false, {"one_fifth_rule"}};
}
Condition with_one_fifth_rule() {
  return {"steps", true, {"one_fifth_rule"}};
}

namespace actuators = science::actuators;

/// A parameter of the chain from output to servo; its range is the actuators' own.
Parameter chain(std::string_view name, std::string_view meaning, const actuators::Range& range, std::string_view unit,
                std::string_view source) {
  return real(name, meaning, {range.minimum, range.maximum, range.default_value, unit}, source, {with_chain()});
}

void add_models(std::vector<Parameter>& rows) {
  rows.insert(
      rows.end(),
      {
          choice("robot", "The robot that is controlled: simulated, or the real quadruped behind a bridge.",
                 {"quadruped", "biped", "bridge"}, "7.2, 7.3 (quadruped); 6.2.1 (biped); 9.4 (bridge)"),
          choice("network", "The neural network, or the plain loop, that generates the gait.", names(network_models()),
                 "7.4.4, eq. 7.11, fig. 7.23 (four_mother); 7.4.3, fig. 7.21 (one_mother); 7.4.2, figs 7.14 and 7.15 "
                 "(recurrent_eight); 2.6.1, fig. 2.7 (split_generator); 9.3, eq. 9.1 (tonic); 9.2 (timed_loop); 6.2.2, "
                 "figs 6.11 and 6.18 (recurrent_pair, feed_forward_pair)"),
          choice(
              "neuron", "The neuron model of a biped's network.",
              {"threshold", "acting_output", "net_as_on_time", "mcculloch_pitts", "timed"},
              "eq. 6.3 (threshold); 6.2.2.2 (acting_output); eq. 6.5 (net_as_on_time); 2.6.1 (mcculloch_pitts, timed)",
              {of_pairs()}),
          choice("weight_range", "Which weights a pair of neurons evolves: from 0 to 1 as printed, or from -1 to 1.",
                 {"as_printed", "either_sign"}, "6.2.2.4 (as_printed); 6.2.2.1, figs 6.12 and 6.19 (either_sign)",
                 {of_pairs(), {"neuron", false, {"net_as_on_time"}}}),
          choice("gait", "The gait that the network is preset with and that sets the expected fitness.",
                 {"walk", "trot", "pace", "gallop", "pronk", "walk_frames"},
                 "7.4.1, 8.2.1, figs 7.5 and 7.12; 7.4.4, appendix D; fig. 7.13 (walk_frames)", {with_preset()}),
          choice("delay_refirings", "Whether the delay before firing delays each firing or only a neuron's first.",
                 {"yes", "no"}, "eq. 7.10 (yes), fig. 7.16 (no)", {{"network", true, {"recurrent_eight"}}}),
          choice("tonic_genes", "What a change of gait mutates: the tonic input, or the weights as well.",
                 {"tonic", "tonic_and_weights"}, "9.3, 9.4", {of_tonic()}),
          choice("actuator",
                 "How outputs move servos: one position per step, or through leaky integrator, reflex and servo.",
                 {"unit_move", "leaky_chain"}, "6.2.1, eqs 6.1 and 6.2; 2.6.1, figs 2.5 and 2.6"),
          chain("integrator_time_constant", "The time constant of the leaky integrator.",
                actuators::integrator_time_constant_range, "steps", "2.6.1, fig. 2.6"),
          chain("actuator_stroke", "How far from standing an unending pulse sends a servo.",
                actuators::actuator_stroke_range, "positions", "2.6.1, fig. 2.5"),
          chain("reflex_gain", "The gain of the reflex on the error of the position.", actuators::reflex_gain_range,
                "1/steps²", "2.6.1, fig. 2.5, eq. 6.1"),
          chain("reflex_damping", "The damping of the reflex by the speed.", actuators::reflex_damping_range, "1/steps",
                "2.6.1, fig. 2.5, eq. 6.1"),
      });
}

void add_operators(std::vector<Parameter>& rows) {
  rows.insert(
      rows.end(),
      {
          choice("trainer", "What tunes the genes.", names(trainer_models()),
                 "4, fig. 4.1 (rtea); 6.2.2.7, fig. 6.29 (ii_rtea); 6.2.2.4, fig. 6.22 (chapter_6_ga); 3.3 "
                 "(genetic_algorithm); 3.4 (simulated_annealing); 3.6 (evolution_strategy); 3.7 "
                 "(evolutionary_programming); 3.8 (hybrid); pagmo2 (pagmo_…)"),
          choice("mutation",
                 "Which child neurons each mutation changes: all, one at random, or those of a random pair of legs.",
                 {"all", "one", "some"}, "4.2.2", {of_rtea()}),
          choice("steps", "How the change of each mutated time is drawn.", {"uniform", "normal", "one_fifth_rule"},
                 "4.2.3, 4.2.4, fig. 8.1", {of_rtea(), not_tonic()}),
          choice("acceptance",
                 "Whether only changes for the better (or equal) are kept, or occasionally worse ones too.",
                 {"simple", "annealing"}, "4.2.5, fig. 8.1", {of_rtea(), not_tonic()}),
          percent("equilibrium_disturbance",
                  "How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps.",
                  50, "8.2.1, fig. 8.1", {with_preset(), not_tonic()}),
          percent(
              "mutation_size",
              "The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps.",
              50, "4.2.3, 8.3.2, figs 4.2 and 8.1", {of_rtea(), not_tonic(), with_step_size()}),
          percent("system_disturbance",
                  "The share of the neurons that is disturbed at the start; where it does not apply all are.", 100,
                  "8.2.2, 8.3, fig. 8.1", {with_preset(), not_tonic(), {"mutation", false, {"some"}}}),
      });
}

void add_surroundings(std::vector<Parameter>& rows) {
  const auto ground = [](std::string_view name, std::string_view meaning) {
    return integer(name, meaning, {0, 30, 10, "positions"}, "eq. 7.1, 9.4", {simulated(), not_frames()});
  };
  rows.insert(
      rows.end(),
      {
          percent("required_stability", "The weight of stability in the fitness.", 100, "8.2.3, eq. 7.4, fig. 8.1",
                  {of_quadruped()}),
          percent("required_distance", "The weight of distance in the fitness.", 100, "8.2.3, eq. 7.4, fig. 8.1",
                  {of_quadruped()}),
          percent("required_fuel", "The weight of the fuel that remains in the fitness.", 100,
                  "8.2.3, eq. 7.4, fig. 8.1", {of_quadruped()}),
          real("push_factor", "How hard a push on the ground drives the body; 1 on flat ground.", {0, 1, 1},
               "1.2, 9.4, eq. 7.7", {simulated(), not_frames()}),
          ground("ground_level_front_left", "Vertical position at which the front left foot meets the ground."),
          ground("ground_level_front_right", "Vertical position at which the front right foot meets the ground."),
          ground("ground_level_back_left", "Vertical position at which the back left foot meets the ground."),
          ground("ground_level_back_right", "Vertical position at which the back right foot meets the ground."),
      });
}

void add_run(std::vector<Parameter>& rows) {
  rows.insert(
      rows.end(),
      {
          integer("cycles", "How many mutations are tried, or candidates evaluated.", {1, 10'000'000, 1000},
                  "8.3, fig. 8.2; appendix B has 2000"),
          integer("time_steps", "The length of one evaluation of the robot.", {1, 10'000, 100, "steps"},
                  "figs 7.12 and 7.13; the 139.375 of 8.3.2 follows from 100; 6.2.2.4 has 40, fig. 7.13 has 9"),
          choice("objective", "What is sought: the fitness of the undisturbed gait, or as much as can be had.",
                 {"target", "maximise"}, "8.2.3 (target), eq. 7.4 (maximise)", {not_tonic()}),
          choice("criterion", "What must not get worse for a change to be kept: each component's error, or their sum.",
                 {"per_component", "total"}, "8.3.2.1 (per_component), 4.2.5 (total)", {of_rtea(), not_tonic()}),
          choice("posture",
                 "Whether each evaluation starts from standing or from where the robot stands after the one before.",
                 {"reset", "carry"}, "8.3.2 (reset), appendix C (carry)",
                 {{"trainer", true, {"rtea", "ii_rtea"}}, not_tonic()}),
          schedule(
              "environment", "At which cycles the weights of the fitness and the ground change, and to what.",
              "1.2, 8.2.3",
              {simulated(), not_frames(), not_tonic(), {"trainer", true, {"rtea"}}, {"objective", true, {"maximise"}}}),
          choice("record",
                 "What is kept besides scores: accepted changes, or also how far the genes moved and De Jong's on-line "
                 "and off-line performance.",
                 {"changes", "details"}, "figs 6.26 and 6.31; K. A. De Jong, 1975"),
      });
}

void add_annealing_and_step_sizes(std::vector<Parameter>& rows) {
  const Condition with_annealing{"acceptance", true, {"annealing"}};
  rows.insert(
      rows.end(),
      {
          real("temperature", "The temperature that scales how much worse a change may be and still be kept.",
               {1e-9, 1e9, 1, "fitness"}, "3.4.2, eq. 3.6", {with_annealing}),
          real("cooling", "The factor on the temperature after every cycle; 1 keeps it constant.", {0.5, 1, 1}, "3.4.3",
               {with_annealing}),
          choice("step_variance",
                 "Whether the variance of normal steps is constant or is multiplied by the square root of the error.",
                 {"constant", "root_error"}, "3.6, 4.2.3, fig. 4.3", {{"steps", true, {"normal"}}}),
          real("first_standard_deviation", "The standard deviation that the 1/5 rule starts with.",
               {0.01, 100, 5, "steps"}, "3.6, 4.2.4", {with_one_fifth_rule()}),
          integer("success_window", "How many mutations the 1/5 rule counts successes over before it adapts.",
                  {1, 10'000, 20, "mutations"}, "3.6, 4.2.4", {with_one_fifth_rule()}),
          real("standard_deviation_factor",
               "What the 1/5 rule multiplies the standard deviation by to shrink it, and divides it by to widen it.",
               {0.1, 0.999, 0.85}, "3.6, 4.2.4", {with_one_fifth_rule()}),
          real("minimum_standard_deviation", "The smallest standard deviation that the 1/5 rule goes down to.",
               {0.001, 100, 0.3, "steps"}, "3.6, 4.2.4", {with_one_fifth_rule()}),
          real("maximum_standard_deviation", "The largest standard deviation that the 1/5 rule goes up to.",
               {0.001, 100, 10, "steps"}, "3.6, 4.2.4, fig. 4.2", {with_one_fifth_rule()}),
      });
}

void add_other_trainers(std::vector<Parameter>& rows) {
  const auto trained_by = [](std::vector<std::string_view> trainers) {
    return Condition{"trainer", true, std::move(trainers)};
  };
  const Condition of_ga = trained_by({"genetic_algorithm", "hybrid"});
  rows.insert(
      rows.end(),
      {
          real("mutation_rate", "The share of the genes that each mutation draws anew.", {0, 100, 75, "%"},
               "6.2.2.4, 6.2.2.5, 6.2.2.7; 3.3.2.7",
               {trained_by({"ii_rtea", "chapter_6_ga", "genetic_algorithm", "hybrid"})}),
          integer("population", "How many members the population has; of an evolution strategy: parents.",
                  {5, 10'000, 40, "members"}, "3.3.2.3, 3.6.1, 3.7; 6.2.2.4 has 40",
                  {trained_by({"genetic_algorithm", "evolution_strategy", "evolutionary_programming", "hybrid",
                               "pagmo_sga", "pagmo_cmaes"})}),
          choice("selection", "How parents are chosen.", {"truncation", "roulette", "tournament"},
                 "3.3.2.4 (truncation), 3.3.2.5 (roulette, tournament)", {of_ga}),
          integer("tournament_size", "How many members compete for being a parent.", {2, 100, 2, "members"},
                  "3.3.2.5, fig. 3.11", {of_ga, {"selection", true, {"tournament"}}}),
          choice("crossover", "How two parents mix.", {"one_point", "two_point", "blend", "michalewicz", "blx_alpha"},
                 "3.3.2.6, eqs 3.3 and 3.4", {of_ga}),
          real("blend_alpha", "How far beyond its parents a child may lie, as a share of their distance.", {0, 2, 0.5},
               "3.3.2.6, BLX-α", {of_ga, {"crossover", true, {"blx_alpha"}}}),
          choice("strategy", "Which evolution strategy.",
                 {"one_plus_one", "mu_plus_one", "mu_plus_lambda", "mu_comma_lambda"}, "3.6.1",
                 {trained_by({"evolution_strategy"})}),
          integer("offspring", "How many children a generation has, λ.", {1, 10'000, 80, "members"}, "3.6.1",
                  {trained_by({"evolution_strategy"}), {"strategy", true, {"mu_plus_lambda", "mu_comma_lambda"}}}),
          real("first_step", "The standard deviation of the first steps.", {0.01, 100, 5, "steps"}, "3.4, 3.6, 3.7",
               {trained_by({"simulated_annealing", "evolution_strategy", "evolutionary_programming"})}),
          real("first_temperature", "The temperature that the schedule starts with.", {1e-9, 1e9, 100, "fitness"},
               "3.4.3", {trained_by({"simulated_annealing"})}),
          real("temperature_factor", "The factor on the temperature after every evaluation.", {0.5, 1, 0.99}, "3.4.3",
               {trained_by({"simulated_annealing"})}),
          integer("hybrid_share", "The share of the evaluations that the genetic algorithm has before refinement.",
                  {1, 99, 50, "%"}, "3.8", {trained_by({"hybrid"})}),
      });
}

std::vector<Parameter> make_registry() {
  std::vector<Parameter> rows;
  add_models(rows);
  add_operators(rows);
  add_surroundings(rows);
  add_run(rows);
  add_annealing_and_step_sizes(rows);
  add_other_trainers(rows);
  return rows;
}

}  // namespace

std::span<const Parameter> registry() {
  static const std::vector<Parameter> rows = make_registry();
  return rows;
}

}  // namespace lamprey::experiment
