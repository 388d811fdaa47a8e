#include "experiment/batch_engine.hpp"
#include "tests/experiment/running/jobs.hpp"

#include <gtest/gtest.h>
#include <thread>
#include <vector>

namespace lamprey::experiment {
namespace {

std::vector<Job> some_jobs() {
  std::vector<Job> jobs;
  for (const char* mutation : {"all", "one", "some"}) {
    for (const char* acceptance : {"simple", "annealing"}) {
      jobs.push_back(job_with({{"mutation", text(mutation)}, {"acceptance", text(acceptance)}, {"cycles", whole(60)}}));
    }
  }
  return jobs;
}

TEST(ScalarEngine, GivesOneResultPerJobInOrder) {
  const auto jobs = some_jobs();
  const auto results = make_scalar_engine()->run(jobs, {});
  ASSERT_EQ(results.size(), jobs.size());
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    EXPECT_EQ(results[i].identity, identity(jobs[i]));
    EXPECT_EQ(std::get<Outcome>(results[i].result), outcome_of(jobs[i]));
    EXPECT_GE(results[i].seconds, 0);
  }
}

TEST(ScalarEngine, AnOutcomeDoesNotDependOnItsNeighboursTheOrderOrTheNumber) {
  auto jobs = some_jobs();
  const auto engine = make_scalar_engine();
  const auto together = engine->run(jobs, {});
  std::vector<Job> reversed(jobs.rbegin(), jobs.rend());
  for (auto& job : reversed) job.number += 1000;
  const auto backwards = engine->run(reversed, {});
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const auto alone = make_scalar_engine()->run(std::span(&jobs[i], 1), {});
    EXPECT_EQ(std::get<Outcome>(alone[0].result), std::get<Outcome>(together[i].result));
    EXPECT_EQ(std::get<Outcome>(backwards[jobs.size() - 1 - i].result), std::get<Outcome>(together[i].result));
  }
}

TEST(ScalarEngine, AJobThatThrowsIsAFailureWithItsReasonAndTheOthersAreDone) {
  auto jobs = some_jobs();
  jobs[1].parameters.set("gait", std::string("moonwalk"));
  const auto results = make_scalar_engine()->run(jobs, {});
  EXPECT_TRUE(std::holds_alternative<Outcome>(results[0].result));
  ASSERT_TRUE(std::holds_alternative<Failure>(results[1].result));
  EXPECT_EQ(std::get<Failure>(results[1].result).reason, "gait is \"moonwalk\", of which there is no model");
  EXPECT_TRUE(std::holds_alternative<Outcome>(results[2].result));
}

TEST(ScalarEngine, AStopInterruptsALongJobAndAllThatFollow) {
  const std::vector<Job> jobs{job_with({{"cycles", whole(10'000'000)}}), job_with({})};
  std::stop_source stop;
  std::vector<BatchResult> results;
  std::jthread runner([&] { results = make_scalar_engine()->run(jobs, stop.get_token()); });
  stop.request_stop();
  runner.join();
  ASSERT_EQ(results.size(), 2U);
  for (const auto& result : results) EXPECT_TRUE(std::holds_alternative<Interrupted>(result.result));
  EXPECT_EQ(results[0].identity, identity(jobs[0]));
}

TEST(ScalarEngine, PrefersOneJobAtATimeAndTakesNone) {
  EXPECT_EQ(make_scalar_engine()->preferred_batch(), 1U);
  EXPECT_TRUE(make_scalar_engine()->run({}, {}).empty());
}

}  // namespace
}  // namespace lamprey::experiment
