#include "benchmarks/simulation/executor.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace lamprey::benchmarks {

namespace {

/// So that none waits for its worker, which looks for ended jobs once in a while.
constexpr std::size_t jobs_in_hand = 8;

}  // namespace

std::optional<Clock::time_point> SimulatedExecutor::next_end() const {
  if (queue_.empty()) return std::nullopt;
  return queue_.front().end;
}

std::size_t SimulatedExecutor::wanted() const {
  return jobs_in_hand - std::min(jobs_in_hand, queue_.size());
}

void SimulatedExecutor::submit(std::vector<worker::Task> tasks) {
  for (auto& task : tasks) {
    const auto start = queue_.empty() ? now_ : queue_.back().end;
    queue_.push_back({std::move(task), start + job_time_});
  }
}

std::vector<worker::FinishedTask> SimulatedExecutor::take_finished() {
  std::vector<worker::FinishedTask> finished;
  for (; !queue_.empty() && queue_.front().end <= now_; queue_.pop_front()) {
    auto& task = queue_.front().task;
    const std::vector<experiment::Job> job{task.grid->job(task.job)};
    auto results = engine_.run(job, {});
    results.front().seconds = std::chrono::duration<double>(job_time_).count();
    finished.push_back({std::move(task), std::move(results.front())});
    busy_ += job_time_;
  }
  return finished;
}

std::vector<messaging::RunningJob> SimulatedExecutor::running() const {
  if (queue_.empty()) return {};
  return {{queue_.front().task.sweep, queue_.front().task.job}};
}

void SimulatedExecutor::drop(const worker::Id128& database, std::uint64_t lease) {
  std::erase_if(queue_,
                [&](const Queued& queued) { return queued.task.database == database && queued.task.lease == lease; });
}

}  // namespace lamprey::benchmarks
