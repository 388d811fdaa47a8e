#include "experiment/checkpoint.hpp"

#include "experiment/models.hpp"
#include "tests/experiment/running/jobs.hpp"

#include <gtest/gtest.h>
#include <ostream>
#include <string>
#include <vector>

namespace lamprey::experiment {
namespace {

using Octets = std::vector<std::uint8_t>;

struct NamedJob {
  std::string name;
  Job job;
};

void PrintTo(const NamedJob& named, std::ostream* out) {
  *out << named.name;
}

void finish(JobRun& run) {
  while (!run.finished()) run.advance();
}

class Resuming : public testing::TestWithParam<NamedJob> {};

TEST_P(Resuming, AtEveryCycleEndsWithTheOutcomeOfTheUndisturbedJob) {
  const Job& job = GetParam().job;
  const Digest name = identity(job);
  const Outcome undisturbed = outcome_of(job);
  const Digest digest = outcome_digest(name, undisturbed);

  JobRun run(job);
  for (std::uint32_t cycle = 0; !run.finished(); ++cycle) {
    ASSERT_EQ(run.outcome().cycles, cycle);
    const Octets octets = write_checkpoint(run, job, 0.5 + cycle);
    ASSERT_FALSE(octets.empty());
    const CheckpointHead head = read_checkpoint_head(octets);
    EXPECT_EQ(head.identity, name);
    EXPECT_EQ(head.cycle, cycle);
    EXPECT_EQ(head.seconds, 0.5 + cycle);
    EXPECT_EQ(read_checkpoint_trace(octets), run.outcome().trace);

    Resumed resumed = resume(job, octets);
    EXPECT_EQ(resumed.seconds, 0.5 + cycle);
    EXPECT_EQ(resumed.run.outcome(), run.outcome());
    EXPECT_EQ(write_checkpoint(resumed.run, job, 0.5 + cycle), octets);
    finish(resumed.run);
    ASSERT_EQ(outcome_digest(name, resumed.run.outcome()), digest) << "from cycle " << cycle;
    run.advance(1);
  }
  EXPECT_EQ(outcome_digest(name, run.outcome()), digest) << "saving disturbs nothing";
  EXPECT_TRUE(write_checkpoint(run, job, 1).empty()) << "a finished run has an outcome instead";
}

TEST_P(Resuming, AgainAndAgainEndsWithThatOutcomeToo) {
  const Job& job = GetParam().job;
  Octets octets = write_checkpoint(JobRun(job), job, 0);
  for (;;) {
    Resumed resumed = resume(job, octets);
    for (int step = 0; step < 7 && !resumed.run.finished(); ++step) resumed.run.advance(1);
    if (resumed.run.finished()) {
      EXPECT_EQ(resumed.run.outcome(), outcome_of(job));
      return;
    }
    octets = write_checkpoint(resumed.run, job, 0);
  }
}

void add(std::vector<NamedJob>& jobs, std::string name, std::initializer_list<Setting> settings) {
  jobs.push_back({std::move(name), job_with(settings)});
}

std::vector<NamedJob> on_line_jobs() {
  std::vector<NamedJob> jobs;
  for (const char* posture : {"reset", "carry"}) {
    const auto name = [&](const std::string& rest) { return std::string(posture) + "_" + rest; };
    for (const char* steps : {"uniform", "normal", "one_fifth_rule"}) {
      for (const char* acceptance : {"simple", "annealing"}) {
        add(jobs, name(std::string(steps) + "_" + acceptance),
            {{"posture", text(posture)},
             {"steps", text(steps)},
             {"acceptance", text(acceptance)},
             {"temperature", 5.0},
             {"cooling", 0.98},
             {"cycles", whole(90)}});
      }
    }
    add(jobs, name("details"),
        {{"posture", text(posture)}, {"record", text("details")}, {"mutation", text("one")}, {"cycles", whole(90)}});
    add(jobs, name("environment"),
        {{"posture", text(posture)},
         {"record", text("details")},
         {"acceptance", text("annealing")},
         {"environment",
          text("20 required_distance=25; 45 push_factor=0.5 required_fuel=50; 46 ground_level_back_left=12")},
         {"cycles", whole(70)}});
    add(jobs, name("ii_rtea"),
        {{"trainer", text("ii_rtea")},
         {"posture", text(posture)},
         {"environment", text("1 required_distance=25; 40 push_factor=0.5")},
         {"cycles", whole(80)}});
  }
  return jobs;
}

/// Every body that there is, carried on from evaluation to evaluation; odd numbers of steps leave windows pending.
std::vector<NamedJob> bodies() {
  std::vector<NamedJob> jobs;
  for (const char* actuator : {"unit_move", "leaky_chain"}) {
    for (const char* network : {"four_mother", "one_mother", "recurrent_eight", "split_generator", "timed_loop"}) {
      add(jobs, std::string(network) + "_" + actuator,
          {{"network", text(network)},
           {"gait", text(network == std::string("split_generator") ? "trot" : "walk")},
           {"actuator", text(actuator)},
           {"posture", text("carry")},
           {"time_steps", whole(37)},
           {"cycles", whole(60)}});
    }
    for (const char* network : {"recurrent_pair", "feed_forward_pair"}) {
      for (const char* neuron : {"threshold", "acting_output", "net_as_on_time", "mcculloch_pitts", "timed"}) {
        add(jobs, std::string(network) + "_" + neuron + "_" + actuator,
            {{"robot", text("biped")},
             {"network", text(network)},
             {"neuron", text(neuron)},
             {"actuator", text(actuator)},
             {"posture", text("carry")},
             {"time_steps", whole(23)},
             {"cycles", whole(60)}});
      }
    }
  }
  for (const char* network : {"one_mother", "recurrent_eight"}) {
    add(jobs, std::string(network) + "_frames",
        {{"network", text(network)},
         {"gait", text("walk_frames")},
         {"posture", text("carry")},
         {"time_steps", whole(31)},
         {"cycles", whole(60)}});
  }
  return jobs;
}

std::vector<NamedJob> changes_of_gait() {
  std::vector<NamedJob> jobs;
  for (const char* mutation : {"all", "one"}) {
    for (const char* genes : {"tonic", "tonic_and_weights"}) {
      add(jobs, std::string(mutation) + "_" + genes,
          {{"network", text("tonic")},
           {"mutation", text(mutation)},
           {"tonic_genes", text(genes)},
           {"environment", text("50 required_distance=25")},
           {"cycles", whole(120)}});
    }
  }
  return jobs;
}

/// Populations whose generations the number of cycles cuts, and saving at every cycle all the more.
std::vector<NamedJob> off_line_jobs() {
  std::vector<NamedJob> jobs;
  add(jobs, "chapter_6_ga", {{"trainer", text("chapter_6_ga")}, {"cycles", whole(130)}});
  for (const char* selection : {"truncation", "roulette", "tournament"}) {
    for (const char* crossover : {"one_point", "two_point", "blend", "michalewicz", "blx_alpha"}) {
      add(jobs, std::string("genetic_algorithm_") + selection + "_" + crossover,
          {{"trainer", text("genetic_algorithm")},
           {"selection", text(selection)},
           {"crossover", text(crossover)},
           {"population", whole(7)},
           {"cycles", whole(40)}});
    }
  }
  add(jobs, "simulated_annealing", {{"trainer", text("simulated_annealing")}, {"cycles", whole(80)}});
  for (const char* strategy : {"one_plus_one", "mu_plus_one", "mu_plus_lambda", "mu_comma_lambda"}) {
    add(jobs, std::string("evolution_strategy_") + strategy,
        {{"trainer", text("evolution_strategy")},
         {"strategy", text(strategy)},
         {"population", whole(5)},
         {"offspring", whole(9)},
         {"cycles", whole(60)}});
  }
  add(jobs, "evolutionary_programming",
      {{"trainer", text("evolutionary_programming")},
       {"population", whole(6)},
       {"record", text("details")},
       {"cycles", whole(50)}});
  add(jobs, "hybrid",
      {{"trainer", text("hybrid")}, {"population", whole(8)}, {"hybrid_share", whole(40)}, {"cycles", whole(75)}});
  add(jobs, "biped_genetic_algorithm",
      {{"trainer", text("genetic_algorithm")},
       {"robot", text("biped")},
       {"network", text("recurrent_pair")},
       {"population", whole(6)},
       {"cycles", whole(40)}});
  return jobs;
}

std::string name_of(const testing::TestParamInfo<NamedJob>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(OnLine, Resuming, testing::ValuesIn(on_line_jobs()), name_of);
INSTANTIATE_TEST_SUITE_P(Bodies, Resuming, testing::ValuesIn(bodies()), name_of);
INSTANTIATE_TEST_SUITE_P(ChangesOfGait, Resuming, testing::ValuesIn(changes_of_gait()), name_of);
INSTANTIATE_TEST_SUITE_P(OffLine, Resuming, testing::ValuesIn(off_line_jobs()), name_of);

TEST(Checkpoint, EveryBitwiseTrainerHasOneAndTheOthersSayThatTheyHaveNone) {
  for (const TrainerModel& model : trainer_models()) {
    const Job job = job_with({{"trainer", std::string(model.name)}, {"cycles", whole(10)}});
    const JobRun run(job);
    EXPECT_EQ(run.can_be_saved(), model.repeatability == Repeatability::bitwise) << model.name;
    EXPECT_EQ(write_checkpoint(run, job, 0).empty(), !run.can_be_saved()) << model.name;
  }
}

TEST(Checkpoint, IsTheSameOctetsOnEveryMachine) {
  const Job job = job_with({{"posture", text("carry")}, {"cycles", whole(20)}});
  JobRun run(job);
  for (int cycle = 0; cycle < 9; ++cycle) run.advance();
  EXPECT_EQ(to_hex(sha256(write_checkpoint(run, job, 1.5))),
            "61e317c3b884fe3cdb7e0eb5d81ae30310f821281538b03753b2680091276085")
      << "other octets are another format: raise its version";
}

}  // namespace
}  // namespace lamprey::experiment
