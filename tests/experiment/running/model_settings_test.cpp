#include "experiment/model_settings.hpp"

#include "tests/experiment/running/jobs.hpp"

#include <gtest/gtest.h>
#include <stdexcept>

namespace lamprey::experiment {
namespace {

using namespace science::evolution;

TEST(RteaSettings, MapsEveryParameter) {
  const RteaSettings rtea = rtea_settings(parameters_with({{"mutation", text("one")},
                                                           {"steps", text("normal")},
                                                           {"acceptance", text("annealing")},
                                                           {"mutation_size", whole(25)},
                                                           {"criterion", text("total")},
                                                           {"posture", text("carry")},
                                                           {"temperature", 2.0},
                                                           {"cooling", 0.75},
                                                           {"step_variance", text("root_error")},
                                                           {"first_standard_deviation", 4.0},
                                                           {"success_window", whole(10)},
                                                           {"standard_deviation_factor", 0.9},
                                                           {"minimum_standard_deviation", 0.5},
                                                           {"maximum_standard_deviation", 8.0}}));
  EXPECT_EQ(rtea.mutation, MutationTechnique::one);
  EXPECT_EQ(rtea.steps, Steps::normal);
  EXPECT_EQ(rtea.size, 2);
  EXPECT_EQ(rtea.step_variance, StepVariance::root_error);
  EXPECT_EQ(rtea.one_fifth_rule.first_standard_deviation, 4);
  EXPECT_EQ(rtea.one_fifth_rule.window, 10U);
  EXPECT_EQ(rtea.one_fifth_rule.factor, 0.9);
  EXPECT_EQ(rtea.one_fifth_rule.minimum_standard_deviation, 0.5);
  EXPECT_EQ(rtea.one_fifth_rule.maximum_standard_deviation, 8);
  EXPECT_EQ(rtea.criterion, Criterion::total);
  EXPECT_EQ(rtea.acceptance, Acceptance::annealing);
  EXPECT_EQ(rtea.temperature, 2);
  EXPECT_EQ(rtea.cooling, 0.75);
  EXPECT_EQ(rtea.posture, Posture::carry);
}

TEST(DisturbanceSettings, MutateSomeDisturbsAllChildren) {
  const auto disturbance = [](const char* mutation) {
    return disturbance_settings(parameters_with(
        {{"mutation", text(mutation)}, {"system_disturbance", whole(25)}, {"equilibrium_disturbance", whole(75)}}));
  };
  EXPECT_EQ(disturbance("one").percent, 25);
  EXPECT_EQ(disturbance("one").size, 7);
  EXPECT_EQ(disturbance("some").percent, 100);
}

TEST(Environment, IsTheWeightsAndTheGroundOfAQuadrupedAndPlainForABiped) {
  const auto settings = parameters_with({{"required_stability", whole(25)},
                                         {"required_distance", whole(75)},
                                         {"required_fuel", whole(50)},
                                         {"push_factor", 0.5},
                                         {"ground_level_front_right", whole(8)},
                                         {"ground_level_back_left", whole(12)}});
  const auto rough = environment(settings);
  EXPECT_EQ(rough.weights.stability, 0.25);
  EXPECT_EQ(rough.weights.distance, 0.75);
  EXPECT_EQ(rough.weights.fuel, 0.5);
  EXPECT_EQ(rough.terrain.push_factor, 0.5);
  EXPECT_EQ(rough.terrain.ground_level, (std::array<std::int16_t, 4>{10, 8, 12, 10}));

  Parameters biped = settings;
  biped.set("robot", text("biped"));
  EXPECT_EQ(environment(biped).weights.stability, 1);
  EXPECT_EQ(environment(biped).terrain, science::robots::Terrain{});
}

}  // namespace
}  // namespace lamprey::experiment
