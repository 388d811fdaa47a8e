#include "experiment/models.hpp"

#include "tests/experiment/running/jobs.hpp"

#include <gtest/gtest.h>
#include <set>
#include <stdexcept>
#include <string>

namespace lamprey::experiment {
namespace {

/// The smallest setting under which the network can be had.
Parameters with_network(std::string_view network) {
  const bool of_biped = network.ends_with("_pair");
  Parameters parameters = parameters_with({{"cycles", whole(6)}, {"time_steps", whole(40)}});
  parameters.set("network", std::string(network));
  if (of_biped) parameters.set("robot", text("biped"));
  if (network == "split_generator") parameters.set("gait", text("trot"));
  return parameters;
}

TEST(NetworkModels, EachMakesAProblemWhoseUnitsHoldEveryGeneOnce) {
  for (const NetworkModel& model : network_models()) {
    SCOPED_TRACE(model.name);
    const auto problem = make_problem(with_network(model.name));
    const auto& plan = problem->plan();
    std::multiset<std::uint32_t> seen;
    for (const auto& unit : plan.units) seen.insert(unit.begin(), unit.end());
    EXPECT_EQ(seen.size(), plan.genes.size());
    EXPECT_EQ(std::set<std::uint32_t>(seen.begin(), seen.end()).size(), plan.genes.size());
    EXPECT_FALSE(plan.kinds.empty());
    const auto preset = problem->preset();
    EXPECT_TRUE(preset.empty() || preset.size() == plan.genes.size());
    for (std::size_t gene = 0; gene < preset.size(); ++gene) {
      EXPECT_EQ(science::evolution::held(plan.genes[gene], preset[gene]), preset[gene]) << gene;
    }
  }
}

TEST(TrainerModels, EachTrainsEachProblemThatItIsMeantFor) {
  for (const TrainerModel& trainer : trainer_models()) {
    for (const char* network : {"four_mother", "timed_loop", "recurrent_pair"}) {
      SCOPED_TRACE(std::string(trainer.name) + " " + network);
      Job job{.seed = 3, .parameters = with_network(network)};
      job.parameters.set("trainer", std::string(trainer.name));
      job.parameters.set("cycles", whole(100));
      const Outcome outcome = outcome_of(job);
      EXPECT_EQ(outcome.cycles, 100U);
      EXPECT_EQ(outcome_of(job), outcome) << "the same job, the same outcome";
    }
  }
}

TEST(Models, SayHowRepeatableTheyAre) {
  EXPECT_EQ(repeatability(Parameters()), Repeatability::bitwise);
  EXPECT_EQ(repeatability(parameters_with({{"trainer", text("pagmo_cmaes")}})), Repeatability::same_build);
  for (const TrainerModel& model : trainer_models()) {
    EXPECT_EQ(model.repeatability == Repeatability::bitwise, !model.name.starts_with("pagmo_")) << model.name;
  }
  EXPECT_EQ(to_text(Repeatability::same_build), "same_build");
}

TEST(Models, AChoiceWithoutAModelIsRefusedByNameAndValue) {
  for (const char* parameter : {"network", "gait", "trainer"}) {
    try {
      outcome_of(job_with({{parameter, text("moonwalk")}}));
      FAIL() << parameter;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()), std::string(parameter) + " is \"moonwalk\", of which there is no model");
    }
  }
}

}  // namespace
}  // namespace lamprey::experiment
