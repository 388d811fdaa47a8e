#include "experiment/batch_engine.hpp"
#include "experiment/checkpoint.hpp"
#include "tests/experiment/running/jobs.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <map>
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

/// Orders as it is told and writes down what it hears.
class Watcher final : public BatchWatcher {
 public:
  std::function<Order(std::size_t job, const Progress&)> orders = [](auto, const auto&) { return Order::go_on; };
  std::map<std::size_t, std::vector<Progress>> looks;
  std::map<std::size_t, std::vector<std::uint8_t>> checkpoints;
  std::map<std::size_t, std::string> refused;

  Order look(std::size_t job, const Progress& progress) override {
    looks[job].push_back(progress);
    return orders(job, progress);
  }
  void saved(std::size_t job, const Progress&, std::vector<std::uint8_t> checkpoint) override {
    checkpoints[job] = std::move(checkpoint);
  }
  void begins_anew(std::size_t job, const std::string& reason) override { refused[job] = reason; }
};

using Order = BatchWatcher::Order;

Job long_job() {
  return job_with({{"acceptance", text("annealing")}, {"posture", text("carry")}, {"cycles", whole(20'000)}});
}

TEST(ScalarEngine, LooksUpBeforeTheFirstStepAndThenWithCyclesAndSecondsThatGrow) {
  const std::vector<Assignment> batch{{.job = job_with({{"cycles", whole(1)}})}, {.job = long_job()}};
  Watcher watcher;
  const auto results = make_scalar_engine()->run(batch, watcher, {});
  EXPECT_EQ(watcher.looks[0].size(), 1U);
  EXPECT_EQ(watcher.looks[0][0].cycle, 0U);
  const auto& looks = watcher.looks[1];
  EXPECT_EQ(looks[0].cycle, 0U);
  EXPECT_GE(looks.size(), 20'000U / 1024U);
  for (std::size_t i = 1; i < looks.size(); ++i) {
    EXPECT_GT(looks[i].cycle, looks[i - 1].cycle);
    EXPECT_GE(looks[i].seconds, looks[i - 1].seconds);
  }
  EXPECT_GE(results[1].seconds, looks.back().seconds);
}

TEST(ScalarEngine, SavingAtEveryLookAndInterruptingWhereverChangesNoOutcome) {
  const Job job = long_job();
  const Outcome undisturbed = outcome_of(job);
  std::vector<Assignment> batch{{.job = job}};
  std::uint32_t last_cycle = 0;
  for (int runs = 1;; ++runs) {
    Watcher watcher;
    watcher.orders = [&](auto, const Progress& progress) {
      return progress.cycle >= last_cycle + 3'000 ? Order::interrupt : Order::save;
    };
    auto result = std::move(make_scalar_engine()->run(batch, watcher, {}).front());
    EXPECT_TRUE(watcher.refused.empty());
    EXPECT_EQ(read_checkpoint_head(watcher.checkpoints.at(0)).identity, identity(job));
    if (const auto* outcome = std::get_if<Outcome>(&result.result)) {
      EXPECT_EQ(*outcome, undisturbed);
      EXPECT_GT(runs, 3);
      return;
    }
    batch[0].checkpoint = std::get<Interrupted>(result.result).checkpoint;
    const auto head = read_checkpoint_head(batch[0].checkpoint);
    EXPECT_GE(head.cycle, last_cycle + 3'000);
    EXPECT_LE(head.seconds, result.seconds);
    last_cycle = head.cycle;
  }
}

TEST(ScalarEngine, AnOrderIsForItsJobAlone) {
  const auto jobs = some_jobs();
  std::vector<Assignment> batch;
  for (const Job& job : jobs) batch.push_back({.job = job});
  Watcher watcher;
  watcher.orders = [](std::size_t job, const auto&) { return job == 2 ? Order::interrupt : Order::go_on; };
  const auto results = make_scalar_engine()->run(batch, watcher, {});
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (i == 2) {
      EXPECT_TRUE(std::holds_alternative<Interrupted>(results[i].result));
    } else {
      EXPECT_EQ(std::get<Outcome>(results[i].result), outcome_of(jobs[i]));
    }
  }
}

TEST(ScalarEngine, ATimeLimitEndsAJobWithItsReasonAndIsNotMetByAShorterOne) {
  const std::vector<Assignment> batch{{.job = job_with({{"cycles", whole(10'000'000)}}), .time_limit = 0.02},
                                      {.job = job_with({{"cycles", whole(10)}}), .time_limit = 3'600}};
  Watcher watcher;
  const auto results = make_scalar_engine()->run(batch, watcher, {});
  EXPECT_EQ(std::get<Failure>(results[0].result).reason, "exceeded its time limit of 0.02 s");
  EXPECT_GE(results[0].seconds, 0.02);
  EXPECT_EQ(std::get<Outcome>(results[1].result), outcome_of(batch[1].job));
}

TEST(ScalarEngine, ACheckpointOfNoUseIsReportedAndTheJobBeginsAnew) {
  const Job job = some_jobs().front();
  const Job other = some_jobs().back();
  const std::vector<Assignment> batch{{.job = job, .checkpoint = write_checkpoint(JobRun(other), other, 0)},
                                      {.job = job, .checkpoint = {1, 2, 3, 4, 5, 6}}};
  Watcher watcher;
  const auto results = make_scalar_engine()->run(batch, watcher, {});
  EXPECT_TRUE(watcher.refused[0].starts_with("it is of the job ")) << watcher.refused[0];
  EXPECT_EQ(watcher.refused[1], "its CRC does not agree: it is damaged or cut");
  for (const auto& result : results) EXPECT_EQ(std::get<Outcome>(result.result), outcome_of(job));
}

TEST(ScalarEngine, AJobThatIsStoppedBeforeItBeganGivesItsCheckpointBack) {
  const Job job = long_job();
  const std::vector<Assignment> batch{{.job = job, .checkpoint = write_checkpoint(JobRun(job), job, 7)}, {.job = job}};
  std::stop_source stop;
  stop.request_stop();
  Watcher watcher;
  const auto results = make_scalar_engine()->run(batch, watcher, stop.get_token());
  EXPECT_EQ(std::get<Interrupted>(results[0].result).checkpoint, batch[0].checkpoint);
  EXPECT_TRUE(std::get<Interrupted>(results[1].result).checkpoint.empty());
  EXPECT_TRUE(watcher.looks.empty());
}

TEST(ScalarEngine, ATrainerThatCannotBeSavedGivesAnEmptyCheckpointAndRunsOn) {
  const Job job = job_with({{"trainer", text("pagmo_sga")}, {"cycles", whole(200)}});
  const std::vector<Assignment> batch{{.job = job}};
  Watcher watcher;
  watcher.orders = [](auto, const auto&) { return Order::save; };
  const auto results = make_scalar_engine()->run(batch, watcher, {});
  EXPECT_TRUE(watcher.checkpoints.at(0).empty());
  EXPECT_EQ(std::get<Outcome>(results[0].result), outcome_of(job));
}

}  // namespace
}  // namespace lamprey::experiment
