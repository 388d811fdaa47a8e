#include "experiment/compatibility.hpp"

#include "experiment/parameters.hpp"
#include "experiment/sweep.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace lamprey::experiment {
namespace {

TEST(Compatibilities, NameChoicesOfTheRegistry) {
  for (const auto& rule : compatibilities()) {
    SCOPED_TRACE(std::string(rule.parameter) + ", " + std::string(rule.other));
    const auto check = [](std::string_view name, const std::vector<std::string_view>& values) {
      const Parameter* parameter = find_parameter(name);
      ASSERT_NE(parameter, nullptr);
      ASSERT_EQ(parameter->kind, ParameterKind::choice);
      EXPECT_FALSE(values.empty());
      for (const auto value : values) {
        EXPECT_NE(std::ranges::find(parameter->choices, value), parameter->choices.end()) << value;
      }
    };
    check(rule.parameter, rule.values);
    check(rule.other, rule.allowed);
    EXPECT_FALSE(rule.reason.empty());
  }
}

TEST(Compatibilities, AllowTheDefaults) {
  const Parameters defaults;
  for (const auto& rule : compatibilities()) {
    const bool concerned = std::ranges::find(rule.values, defaults.choice(rule.parameter)) != rule.values.end();
    const bool allowed = std::ranges::find(rule.allowed, defaults.choice(rule.other)) != rule.allowed.end();
    EXPECT_TRUE(!concerned || allowed) << rule.parameter << ", " << rule.other;
  }
}

bool allowed(const std::string& base) {
  try {
    parse_sweep("name: a\nbase: {" + base + "}\n", "a");
    return true;
  } catch (const InvalidInput&) {
    return false;
  }
}

TEST(Compatibilities, BindTheBipedToItsNetworks) {
  EXPECT_FALSE(allowed("robot: biped"));
  EXPECT_FALSE(allowed("robot: biped, network: tonic"));
  EXPECT_FALSE(allowed("network: recurrent_pair"));
  EXPECT_TRUE(allowed("robot: biped, network: recurrent_pair"));
  EXPECT_TRUE(allowed("robot: biped, network: feed_forward_pair"));
}

TEST(Compatibilities, BindGaitsToTheNetworksThatHaveThem) {
  EXPECT_TRUE(allowed("gait: pronk"));
  EXPECT_TRUE(allowed("network: one_mother, gait: walk_frames"));
  EXPECT_FALSE(allowed("network: timed_loop, gait: walk_frames"));
  EXPECT_TRUE(allowed("network: recurrent_eight, gait: walk_frames"));
  EXPECT_TRUE(allowed("network: recurrent_eight"));
  EXPECT_FALSE(allowed("network: recurrent_eight, gait: trot"));
  EXPECT_FALSE(allowed("network: split_generator"));
  EXPECT_TRUE(allowed("network: split_generator, gait: gallop"));
  EXPECT_TRUE(allowed("network: tonic, gait: gallop"));
  EXPECT_FALSE(allowed("network: tonic, gait: pronk"));
  EXPECT_FALSE(allowed("network: tonic, trainer: hybrid"));
  EXPECT_FALSE(allowed("network: one_mother, gait: walk_frames, actuator: leaky_chain"));
}

TEST(Compatibilities, BindMutateSomeToNetworksWithPairsOfLegs) {
  EXPECT_TRUE(allowed("mutation: some, network: timed_loop"));
  EXPECT_FALSE(allowed("mutation: some, network: tonic"));
  EXPECT_FALSE(allowed("mutation: some, network: recurrent_pair, robot: biped"));
}

bool allowed_grid(const std::string& axes) {
  try {
    parse_sweep("name: a\ngrids: [{" + axes + "}]\n", "a");
    return true;
  } catch (const InvalidInput&) {
    return false;
  }
}

TEST(Compatibilities, AreAskedOnlyWhereBothParametersApply) {
  // mutation does not apply to the II-RTEA, nor gait to the biped; where they apply, the other value is met.
  EXPECT_TRUE(allowed_grid("robot: biped, network: recurrent_pair, trainer: [ii_rtea, chapter_6_ga]"));
  EXPECT_TRUE(allowed_grid("trainer: rtea, mutation: some, network: [four_mother, one_mother]"));
  EXPECT_FALSE(allowed_grid("trainer: rtea, mutation: some, network: [four_mother, tonic]"));
  EXPECT_TRUE(allowed_grid("steps: normal, step_variance: root_error, objective: target"));
  EXPECT_FALSE(allowed_grid("steps: normal, step_variance: root_error, objective: [target, maximise]"));
}

}  // namespace
}  // namespace lamprey::experiment
