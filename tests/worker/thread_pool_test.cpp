#include "worker/job_executor.hpp"

#include <chrono>
#include <gtest/gtest.h>
#include <map>
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
  while (pool->running().empty()) std::this_thread::yield();
  pool->stop();
  EXPECT_TRUE(pool->running().empty());
  for (const auto& finished : pool->take_finished()) {
    EXPECT_TRUE(std::holds_alternative<experiment::Interrupted>(finished.result.result));
  }
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

}  // namespace
}  // namespace lamprey::worker
