#include "experiment/parameters.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>

namespace lamprey::experiment {
namespace {

TEST(ToText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(to_text(Value("walk")), "walk");
  EXPECT_EQ(to_text(Value(std::int64_t{1000})), "1000");
  EXPECT_EQ(to_text(Value(std::numeric_limits<std::int64_t>::min())), "-9223372036854775808");
  EXPECT_EQ(to_text(Value(0.85)), "0.85");
  EXPECT_EQ(to_text(Value(1.0)), "1");
  EXPECT_EQ(to_text(Value(0.1 + 0.2)), "0.30000000000000004");
  EXPECT_EQ(to_text(Value(1e-9)), "1e-09");
  EXPECT_EQ(to_text(Value(-std::numeric_limits<double>::denorm_min())), "-5e-324");
}

TEST(Parameters, StartWithAllDefaults) {
  const Parameters parameters;
  for (std::size_t row = 0; row < registry().size(); ++row) {
    EXPECT_EQ(parameters[row], registry()[row].default_value) << registry()[row].name;
  }
}

TEST(Parameters, AreReadByNameAndKind) {
  Parameters parameters;
  parameters.set("cycles", std::int64_t{5});
  parameters.set("temperature", 0.5);
  EXPECT_EQ(parameters.integer("cycles"), 5);
  EXPECT_EQ(parameters.real("temperature"), 0.5);
  EXPECT_EQ(parameters.choice("gait"), "walk");
  EXPECT_THROW(parameters.get("gaitt"), std::out_of_range);
  EXPECT_THROW(parameters.set("gaitt", std::int64_t{1}), std::out_of_range);
  EXPECT_THROW(parameters.integer("temperature"), std::bad_variant_access);
}

TEST(Parameters, ApplyAsTheirConditionsSay) {
  Parameters parameters;
  const auto applies = [&](const char* name) { return parameters.applies(parameter_index(name)); };
  EXPECT_TRUE(applies("mutation_size"));
  EXPECT_TRUE(applies("system_disturbance"));
  EXPECT_FALSE(applies("temperature"));
  EXPECT_FALSE(applies("step_variance"));
  EXPECT_FALSE(applies("success_window"));
  parameters.set("steps", "one_fifth_rule");
  EXPECT_FALSE(applies("mutation_size"));
  EXPECT_TRUE(applies("success_window"));
  parameters.set("mutation", "some");
  EXPECT_FALSE(applies("system_disturbance"));
  parameters.set("acceptance", "annealing");
  EXPECT_TRUE(applies("temperature"));
  parameters.set("steps", "normal");
  EXPECT_TRUE(applies("step_variance"));
}

TEST(Parameters, DoNotApplyWhereWhatTheyAskForDoesNot) {
  Parameters parameters;
  const auto applies = [&](const char* name) { return parameters.applies(parameter_index(name)); };
  parameters.set("acceptance", "annealing");
  parameters.set("trainer", "hybrid");
  EXPECT_TRUE(applies("acceptance"));
  EXPECT_TRUE(applies("temperature"));
  parameters.set("trainer", "genetic_algorithm");  // has no acceptance, whatever its value
  EXPECT_FALSE(applies("acceptance"));
  EXPECT_FALSE(applies("temperature"));
  EXPECT_FALSE(applies("mutation_size")) << "steps does not apply, so that it isn't one_fifth_rule decides nothing";
  parameters.set("selection", "tournament");
  EXPECT_TRUE(applies("tournament_size"));
  parameters.set("trainer", "rtea");
  EXPECT_FALSE(applies("tournament_size"));
}

TEST(Parameters, ApplyWhereAConditionNamesOneOfSeveralValues) {
  Parameters parameters;
  const auto applies = [&](const char* name) { return parameters.applies(parameter_index(name)); };
  EXPECT_TRUE(applies("gait"));
  EXPECT_FALSE(applies("neuron"));
  parameters.set("network", "feed_forward_pair");
  EXPECT_FALSE(applies("gait"));
  EXPECT_TRUE(applies("neuron"));
  parameters.set("network", "recurrent_pair");
  EXPECT_FALSE(applies("gait"));
  EXPECT_TRUE(applies("neuron"));
}

TEST(ConditionsOf, HasThoseOfWhatIsAskedForFirstAndNoneTwice) {
  for (std::size_t row = 0; row < registry().size(); ++row) {
    const auto conditions = conditions_of(row);
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      EXPECT_EQ(std::ranges::count(conditions, conditions[i]), 1) << registry()[row].name;
      for (const auto& asked : conditions_of(conditions[i].row)) {
        EXPECT_LT(std::ranges::find(conditions, asked) - conditions.begin(), static_cast<std::ptrdiff_t>(i))
            << registry()[row].name;
      }
    }
  }
}

TEST(CanonicalText, IsEmptyForDefaults) {
  EXPECT_EQ(canonical_text(Parameters()), "");
}

TEST(CanonicalText, HasWhatAppliesAndDiffersSortedByName) {
  Parameters parameters;
  parameters.set("steps", "one_fifth_rule");
  parameters.set("mutation", "one");
  parameters.set("mutation_size", std::int64_t{75});  // does not apply to the 1/5 rule
  parameters.set("temperature", 2.5);                 // does not apply to simple acceptance
  parameters.set("standard_deviation_factor", 0.9);
  parameters.set("cycles", std::int64_t{1000});  // the default
  parameters.set("equilibrium_disturbance", std::int64_t{25});
  EXPECT_EQ(canonical_text(parameters),
            "equilibrium_disturbance=25\nmutation=one\nstandard_deviation_factor=0.9\nsteps=one_fifth_rule\n");
}

TEST(CanonicalText, DoesNotDependOnWhatDoesNotApply) {
  Parameters one;
  Parameters other;
  other.set("temperature", 7.0);
  other.set("success_window", std::int64_t{3});
  EXPECT_EQ(canonical_text(one), canonical_text(other));
  one.set("acceptance", "annealing");
  other.set("acceptance", "annealing");
  EXPECT_NE(canonical_text(one), canonical_text(other));
}

TEST(ToJson, HasWhatAppliesInTheRegistrysOrder) {
  Parameters parameters;
  parameters.set("network", "tonic");
  parameters.set("mutation", "one");
  EXPECT_EQ(to_json(parameters),
            R"({"robot":"quadruped","network":"tonic","gait":"walk","tonic_genes":"tonic","actuator":"unit_move",)"
            R"("trainer":"rtea","mutation":"one","required_stability":100,"required_distance":100,)"
            R"("required_fuel":100,"push_factor":1,"ground_level_front_left":10,"ground_level_front_right":10,)"
            R"("ground_level_back_left":10,"ground_level_back_right":10,"cycles":1000,"time_steps":100,)"
            R"("record":"changes"})");
}

TEST(ToJson, WritesRealsShortestAndEscapesText) {
  Parameters parameters;
  parameters.set("acceptance", "annealing");
  parameters.set("temperature", 0.1);
  parameters.set("gait", "a\"b\\c\n");
  const std::string json = to_json(parameters);
  EXPECT_NE(json.find(R"("temperature":0.1,"cooling":1})"), std::string::npos) << json;
  EXPECT_NE(json.find(R"("gait":"a\"b\\c\u000a",)"), std::string::npos) << json;
}

}  // namespace
}  // namespace lamprey::experiment
