#include "experiment/checkpoint.hpp"
#include "worker/job_executor.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <sys/resource.h>
#include <thread>

namespace lamprey::worker {
namespace {

std::shared_ptr<const experiment::SweepGrid> grid(const std::string& base) {
  const auto file = experiment::parse_sweep("name: pool\nbase: {" + base + "}\nreplicates: 64\n", "test");
  return std::make_shared<const experiment::SweepGrid>(file.specification);
}

std::vector<Task> tasks(const std::shared_ptr<const experiment::SweepGrid>& grid, std::uint64_t lease) {
  std::vector<Task> list;
  for (std::uint64_t job = 0; job < grid->jobs(); ++job) list.push_back({{1, 1}, {2, 2}, lease, job, grid});
  return list;
}

std::map<std::uint64_t, experiment::BatchResult> collect(JobExecutor& pool, messaging::Signal& signal) {
  std::map<std::uint64_t, experiment::BatchResult> results;
  while (!pool.idle()) {
    signal.wait_for(std::chrono::milliseconds{100});
    for (auto& finished : pool.take_finished()) results.emplace(finished.task.job, std::move(finished.result));
  }
  return results;
}

TEST(ThreadPool, AnyNumberOfThreadsGivesTheSameOutcomes) {
  const auto jobs = grid("cycles: 20, acceptance: annealing");
  std::map<std::uint64_t, experiment::BatchResult> reference;
  for (const std::uint32_t threads : {1U, 2U, 5U}) {
    auto signal = std::make_shared<messaging::Signal>();
    const auto pool = make_thread_pool(threads, signal);
    EXPECT_EQ(pool->threads(), threads);
    EXPECT_GE(pool->wanted(), threads);
    pool->submit(tasks(jobs, 1));
    auto results = collect(*pool, *signal);
    ASSERT_EQ(results.size(), 64U);
    if (reference.empty()) reference = std::move(results);
    for (const auto& [job, result] : results) {
      EXPECT_EQ(std::get<experiment::Outcome>(result.result), std::get<experiment::Outcome>(reference.at(job).result));
    }
  }
}

TEST(ThreadPool, StopInterruptsWhatRunsAndLosesNothingThatHasEnded) {
  auto signal = std::make_shared<messaging::Signal>();
  const auto pool = make_thread_pool(2, signal);
  pool->submit(tasks(grid("cycles: 10000000"), 1));
  const auto begun = [](const messaging::RunningJob& job) { return job.cycle > 0; };
  while (std::ranges::none_of(pool->running(), begun)) std::this_thread::yield();
  pool->stop();
  EXPECT_TRUE(pool->running().empty());
  bool handed_over = false;
  for (const auto& finished : pool->take_finished()) {
    EXPECT_TRUE(std::holds_alternative<experiment::Interrupted>(finished.result.result));
    handed_over = handed_over || finished.checkpoint.has_value();
  }
  EXPECT_TRUE(handed_over);
  EXPECT_TRUE(pool->idle());
}

TEST(ThreadPool, DropTakesOnlyThatLeasesWaitingJobs) {
  auto signal = std::make_shared<messaging::Signal>();
  const auto pool = make_thread_pool(1, signal);
  pool->submit(tasks(grid("cycles: 2000"), 1));
  pool->submit(tasks(grid("cycles: 1"), 2));
  pool->drop({1, 1}, 1);
  std::size_t of_second = 0;
  std::size_t of_first = 0;
  while (!pool->idle()) {
    signal->wait_for(std::chrono::milliseconds{100});
    for (const auto& finished : pool->take_finished()) (finished.task.lease == 2 ? of_second : of_first) += 1;
  }
  EXPECT_EQ(of_second, 64U);
  EXPECT_LT(of_first, 64U);
}

using Grid = std::shared_ptr<const experiment::SweepGrid>;

constexpr const char* endless = "cycles: 10000000";

/// A single job of the grid.
Task one(const Grid& grid, std::uint64_t lease = 1, std::uint64_t job = 0) {
  return {{1, 1}, {2, 2}, lease, job, grid};
}

FinishedTask next_finished(JobExecutor& pool, messaging::Signal& signal) {
  for (;;) {
    auto finished = pool.take_finished();
    EXPECT_LE(finished.size(), 1U);
    if (!finished.empty()) return std::move(finished.front());
    signal.wait_for(std::chrono::milliseconds{100});
  }
}

void wait_until_it_runs(const JobExecutor& pool) {
  while (std::ranges::none_of(pool.running(), [](const auto& job) { return job.cycle > 0; })) {
    std::this_thread::yield();
  }
}

experiment::Outcome undisturbed(const Grid& grid, std::uint64_t job = 0) {
  return std::get<experiment::Outcome>(experiment::run_job(grid->job(job), {}));
}

TEST(ThreadPool, AJobThatIsInterruptedEndsElsewhereWithTheSameOutcome) {
  const auto jobs = grid("cycles: 400000, time_steps: 1, acceptance: annealing, posture: carry");
  auto signal = std::make_shared<messaging::Signal>();
  FinishedTask first;
  do {  // until it does not end before it is interrupted
    const auto pool = make_thread_pool(1, signal);
    pool->submit({one(jobs)});
    wait_until_it_runs(*pool);
    pool->interrupt({1, 1}, 1);
    first = next_finished(*pool, *signal);
  } while (!std::holds_alternative<experiment::Interrupted>(first.result.result));

  ASSERT_TRUE(first.checkpoint.has_value());
  EXPECT_EQ(first.checkpoint->origin.database, (Id128{1, 1}));
  EXPECT_EQ(first.checkpoint->sweep, (Id128{2, 2}));
  EXPECT_EQ(first.checkpoint->lease, 1U);
  EXPECT_EQ(first.checkpoint->job, 0U);
  EXPECT_EQ(first.checkpoint->identity, experiment::identity(jobs->job(0)));
  EXPECT_GT(first.checkpoint->cycle, 0U);
  EXPECT_GT(first.checkpoint->seconds, 0);

  const auto elsewhere = make_thread_pool(1, signal);
  Task rest = one(jobs, 2);
  rest.checkpoint = first.checkpoint->state;
  elsewhere->submit({rest});
  const auto second = next_finished(*elsewhere, *signal);
  EXPECT_EQ(std::get<experiment::Outcome>(second.result.result), undisturbed(jobs));
  EXPECT_GT(second.result.seconds, first.checkpoint->seconds) << "seconds are of all attempts";
  EXPECT_FALSE(second.checkpoint.has_value());
  EXPECT_TRUE(second.task.checkpoint.empty());
  EXPECT_GE(second.waited, 0);
}

TEST(ThreadPool, StopHandsOverTheCheckpointsOfWhatItInterrupts) {
  auto signal = std::make_shared<messaging::Signal>();
  const auto pool = make_thread_pool(1, signal);
  pool->submit({one(grid(endless))});
  wait_until_it_runs(*pool);
  pool->stop();
  const auto finished = pool->take_finished();
  ASSERT_EQ(finished.size(), 1U);
  ASSERT_TRUE(finished[0].checkpoint.has_value());
  EXPECT_EQ(experiment::read_checkpoint_head(finished[0].checkpoint->state).cycle, finished[0].checkpoint->cycle);
  EXPECT_TRUE(pool->idle());
}

TEST(ThreadPool, AJobThatExceedsItsTimeLimitFailsAndItsNeighboursDoNot) {
  auto signal = std::make_shared<messaging::Signal>();
  const auto pool = make_thread_pool(1, signal);
  Task limited = one(grid(endless));
  limited.time_limit = 0.03;
  const auto quick = grid("cycles: 20");
  pool->submit({limited, one(quick, 1, 1), one(quick, 1, 2)});
  auto results = collect(*pool, *signal);
  ASSERT_EQ(results.size(), 3U);
  EXPECT_EQ(std::get<experiment::Failure>(results.at(0).result).reason, "exceeded its time limit of 0.03 s");
  EXPECT_GE(results.at(0).seconds, 0.03);
  EXPECT_EQ(std::get<experiment::Outcome>(results.at(1).result), undisturbed(quick, 1));
  EXPECT_EQ(std::get<experiment::Outcome>(results.at(2).result), undisturbed(quick, 2));
}

TEST(ThreadPool, TheSecondsBeforeACheckpointCountForTheTimeLimit) {
  const auto jobs = grid(endless);
  const experiment::Job job = jobs->job(0);
  auto signal = std::make_shared<messaging::Signal>();
  const auto pool = make_thread_pool(1, signal);
  Task late = one(jobs);
  late.checkpoint = experiment::write_checkpoint(experiment::JobRun(job), job, 61);
  late.time_limit = 60;
  pool->submit({late});
  const auto finished = next_finished(*pool, *signal);
  EXPECT_EQ(std::get<experiment::Failure>(finished.result.result).reason, "exceeded its time limit of 60 s");
  EXPECT_GE(finished.result.seconds, 61);
}

TEST(ThreadPool, ARunningJobIsCheckpointedAgainAndAgainAndOnlyTheNewestIsTaken) {
  const auto jobs = grid(endless);
  auto signal = std::make_shared<messaging::Signal>();
  const auto pool = make_thread_pool(2, signal, std::chrono::milliseconds{2});
  pool->submit({one(jobs, 1, 0), one(jobs, 1, 1)});
  std::map<std::uint64_t, std::uint32_t> newest;
  std::map<std::uint64_t, int> taken;
  while (taken[0] < 3 || taken[1] < 3) {
    signal->wait_for(std::chrono::milliseconds{100});
    std::set<std::uint64_t> now;
    for (const auto& checkpoint : pool->take_checkpoints()) {
      EXPECT_TRUE(now.insert(checkpoint.job).second);
      EXPECT_GT(checkpoint.cycle, newest[checkpoint.job]);
      newest[checkpoint.job] = checkpoint.cycle;
      ++taken[checkpoint.job];
      const auto head = experiment::read_checkpoint_head(checkpoint.state);
      EXPECT_EQ(head.identity, experiment::identity(jobs->job(checkpoint.job)));
      EXPECT_EQ(checkpoint.identity, head.identity);
      EXPECT_EQ(checkpoint.cycle, head.cycle);
      EXPECT_EQ(checkpoint.seconds, head.seconds);
    }
  }
  for (const auto& job : pool->running()) {
    EXPECT_GE(job.cycle, newest[job.job]);
    EXPECT_GT(job.seconds, 0);
  }
  pool->stop();
  EXPECT_TRUE(pool->take_checkpoints().empty()) << "what was interrupted has come back with its own";
}

TEST(ThreadPool, ShortJobsAndTrainersThatCannotBeSavedHaveNoCheckpoints) {
  auto signal = std::make_shared<messaging::Signal>();
  const auto pool = make_thread_pool(1, signal, std::chrono::milliseconds{1});
  pool->submit(tasks(grid("cycles: 1"), 1));
  while (!pool->idle()) {
    signal->wait_for(std::chrono::milliseconds{100});
    pool->take_finished();
    EXPECT_TRUE(pool->take_checkpoints().empty());
  }
  pool->submit({one(grid("trainer: pagmo_sga, cycles: 1000000"))});
  wait_until_it_runs(*pool);
  pool->interrupt({1, 1}, 1);
  const auto finished = next_finished(*pool, *signal);
  EXPECT_TRUE(std::holds_alternative<experiment::Interrupted>(finished.result.result));
  EXPECT_FALSE(finished.checkpoint.has_value());
  EXPECT_TRUE(pool->take_checkpoints().empty());
}

TEST(ThreadPool, InterruptEndsOneLeasesJobsAndLeavesTheOthersAlone) {
  auto signal = std::make_shared<messaging::Signal>();
  const auto pool = make_thread_pool(2, signal);
  const auto jobs = grid(endless);
  pool->submit({one(jobs, 1, 0), one(jobs, 2, 1), one(jobs, 1, 2), one(jobs, 2, 3)});
  while (pool->running().size() < 2) std::this_thread::yield();
  pool->interrupt({9, 9}, 1);  // another database's lease of that number
  pool->interrupt({1, 1}, 1);
  const auto finished = next_finished(*pool, *signal);
  EXPECT_TRUE(std::holds_alternative<experiment::Interrupted>(finished.result.result));
  EXPECT_EQ(finished.task.job, 0U);
  std::set<std::uint64_t> left;
  while (left.size() < 2) {
    for (const auto& job : pool->running()) left.insert(job.job);
  }
  EXPECT_EQ(left, (std::set<std::uint64_t>{1, 3})) << "job 2 never starts";
  EXPECT_TRUE(pool->take_finished().empty());
}

TEST(ThreadPool, ATaskWhoseCheckpointIsOfNoUseBeginsAnew) {
  const auto jobs = grid("cycles: 50");
  auto signal = std::make_shared<messaging::Signal>();
  const auto pool = make_thread_pool(1, signal);
  const experiment::Job other = jobs->job(1);
  Task wrong = one(jobs);
  wrong.checkpoint = experiment::write_checkpoint(experiment::JobRun(other), other, 1'000);
  pool->submit({wrong});
  const auto finished = next_finished(*pool, *signal);
  EXPECT_EQ(std::get<experiment::Outcome>(finished.result.result), undisturbed(jobs));
  EXPECT_LT(finished.result.seconds, 1'000);
}

/// The niceness of each thread of this process.
std::multiset<int> niceness() {
  std::multiset<int> all;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    all.insert(::getpriority(PRIO_PROCESS, static_cast<id_t>(std::stoul(task.path().filename().string()))));
  }
  return all;
}

TEST(ThreadPool, OnlyWhatComputesYields) {
  auto signal = std::make_shared<messaging::Signal>();
  const int own = ::getpriority(PRIO_PROCESS, 0);
  const auto pool = make_thread_pool(2, signal, default_checkpoint_interval, 3);
  pool->submit(tasks(grid("cycles: 1"), 1));
  collect(*pool, *signal);
  // A thread that has computed nothing may not have begun yet.
  while (niceness().count(own + 3) < 2) std::this_thread::yield();
  EXPECT_EQ(::getpriority(PRIO_PROCESS, 0), own);
}

TEST(ThreadPool, WhatWaitsBehindALongJobIsComputedByOtherThreads) {
  auto signal = std::make_shared<messaging::Signal>();
  const auto pool = make_thread_pool(2, signal);
  pool->submit(tasks(grid("cycles: 1"), 1));  // from which the pool learns to hand out many at once
  collect(*pool, *signal);
  const auto quick = grid("cycles: 2");
  std::vector<Task> mixed{one(grid(endless), 2)};
  for (auto& task : tasks(quick, 3)) mixed.push_back(std::move(task));
  pool->submit(std::move(mixed));
  std::size_t done = 0;
  while (done < 64) {
    signal->wait_for(std::chrono::milliseconds{100});
    for (const auto& finished : pool->take_finished()) done += finished.task.lease == 3;
  }
  ASSERT_EQ(pool->running().size(), 1U);
  EXPECT_FALSE(pool->idle());
}

}  // namespace
}  // namespace lamprey::worker
