#include "experiment/parameters.hpp"

namespace lamprey::experiment {

namespace {

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

std::vector<Parameter> make_registry() {
  const std::vector<Condition> with_step_size = {{"steps", false, "one_fifth_rule"}};
  const std::vector<Condition> with_annealing = {{"acceptance", true, "annealing"}};
  const std::vector<Condition> with_one_fifth_rule = {{"steps", true, "one_fifth_rule"}};
  return {
      choice("robot", "The robot that is controlled.", {"quadruped"}, "7.2, 7.3"),
      choice("network", "The neural network that generates the gait.", {"four_mother"}, "7.4.4, eq. 7.11, fig. 7.23"),
      choice("gait", "The gait that the network is preset with and that sets the expected fitness.", {"walk"},
             "7.4.1, 8.2.1, figs 7.5 and 7.12"),
      choice("mutation",
             "Which child neurons each mutation changes: all, one at random, or those of a random pair of legs.",
             {"all", "one", "some"}, "4.2.2"),
      choice("steps", "How the change of each mutated time is drawn.", {"uniform", "normal", "one_fifth_rule"},
             "4.2.3, 4.2.4, fig. 8.1"),
      choice("acceptance", "Whether only changes for the better (or equal) are kept, or occasionally worse ones too.",
             {"simple", "annealing"}, "4.2.5, fig. 8.1"),
      percent("equilibrium_disturbance",
              "How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps.", 50,
              "8.2.1, fig. 8.1"),
      percent("mutation_size",
              "The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps.",
              50, "4.2.3, 8.3.2, figs 4.2 and 8.1", with_step_size),
      percent("system_disturbance", "The share of the eight child neurons that is disturbed at the start.", 100,
              "8.2.2, 8.3, fig. 8.1", {{"mutation", false, "some"}}),
      percent("required_stability", "The weight of stability in the fitness.", 100, "8.2.3, eq. 7.4, fig. 8.1"),
      percent("required_distance", "The weight of distance in the fitness.", 100, "8.2.3, eq. 7.4, fig. 8.1"),
      percent("required_fuel", "The weight of the fuel that remains in the fitness.", 100, "8.2.3, eq. 7.4, fig. 8.1"),
      integer("cycles", "How many mutations are tried.", {1, 10'000'000, 1000}, "8.3, fig. 8.2; appendix B has 2000"),
      integer("time_steps", "The length of one evaluation of the robot.", {1, 10'000, 100, "steps"},
              "figs 7.12 and 7.13; the 139.375 of 8.3.2 follows from 100"),
      choice("objective", "What is sought: the fitness of the undisturbed gait, or as much as can be had.",
             {"target", "maximise"}, "8.2.3 (target), eq. 7.4 (maximise)"),
      choice("criterion", "What must not get worse for a change to be kept: each component's error, or their sum.",
             {"per_component", "total"}, "8.3.2.1 (per_component), 4.2.5 (total)"),
      choice("posture",
             "Whether each evaluation starts from standing or from where the robot stands after the one before.",
             {"reset", "carry"}, "8.3.2 (reset), appendix C (carry)"),
      real("temperature", "The temperature that scales how much worse a change may be and still be kept.",
           {1e-9, 1e9, 1, "fitness"}, "3.4.2, eq. 3.6", with_annealing),
      real("cooling", "The factor on the temperature after every cycle; 1 keeps it constant.", {0.5, 1, 1}, "3.4.3",
           with_annealing),
      choice("step_variance",
             "Whether the variance of normal steps is constant or is multiplied by the square root of the error.",
             {"constant", "root_error"}, "3.6, 4.2.3, fig. 4.3", {{"steps", true, "normal"}}),
      real("first_standard_deviation", "The standard deviation that the 1/5 rule starts with.", {0.01, 100, 5, "steps"},
           "3.6, 4.2.4", with_one_fifth_rule),
      integer("success_window", "How many mutations the 1/5 rule counts successes over before it adapts.",
              {1, 10'000, 20, "mutations"}, "3.6, 4.2.4", with_one_fifth_rule),
      real("standard_deviation_factor",
           "What the 1/5 rule multiplies the standard deviation by to shrink it, and divides it by to widen it.",
           {0.1, 0.999, 0.85}, "3.6, 4.2.4", with_one_fifth_rule),
      real("minimum_standard_deviation", "The smallest standard deviation that the 1/5 rule goes down to.",
           {0.001, 100, 0.3, "steps"}, "3.6, 4.2.4", with_one_fifth_rule),
      real("maximum_standard_deviation", "The largest standard deviation that the 1/5 rule goes up to.",
           {0.001, 100, 10, "steps"}, "3.6, 4.2.4, fig. 4.2", with_one_fifth_rule),
  };
}

}  // namespace

std::span<const Parameter> registry() {
  static const std::vector<Parameter> rows = make_registry();
  return rows;
}

}  // namespace lamprey::experiment
