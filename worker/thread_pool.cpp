#include "worker/job_executor.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace lamprey::worker {

namespace {

/// Computation that one handing-over should amount to: long against its cost, short against a heartbeat.
constexpr double target_seconds = 0.02;
constexpr std::size_t most_jobs_at_once = 1024;

class ThreadPool final : public JobExecutor {
 public:
  ThreadPool(std::uint32_t threads, std::shared_ptr<messaging::Signal> signal) : signal_(std::move(signal)) {
    slots_.resize(std::max(threads, 1U));
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      threads_.emplace_back([this, i](const std::stop_token& stop) { run(stop, i); });
    }
  }

  ~ThreadPool() override { ThreadPool::stop(); }

  void stop() override {
    {
      const std::scoped_lock lock(mutex_);
      queue_.clear();
    }
    for (auto& thread : threads_) thread.request_stop();
    threads_.clear();  // joins
  }

  std::size_t wanted() const override {
    const std::scoped_lock lock(mutex_);
    const std::size_t target = 2 * slots_.size() * chunk_;
    return target - std::min(target, queue_.size());
  }

  void submit(std::vector<Task> tasks) override {
    {
      const std::scoped_lock lock(mutex_);
      for (auto& task : tasks) queue_.push_back(std::move(task));
    }
    wake_.notify_all();
  }

  std::vector<FinishedTask> take_finished() override {
    const std::scoped_lock lock(mutex_);
    return std::exchange(finished_, {});
  }

  std::vector<messaging::RunningJob> running() const override {
    const std::scoped_lock lock(mutex_);
    std::vector<messaging::RunningJob> jobs;
    for (const auto& slot : slots_) jobs.insert(jobs.end(), slot.begin(), slot.end());
    return jobs;
  }

  void drop(const Id128& database, std::uint64_t lease) override {
    const std::scoped_lock lock(mutex_);
    std::erase_if(queue_, [&](const Task& task) { return task.database == database && task.lease == lease; });
  }

  bool idle() const override {
    const std::scoped_lock lock(mutex_);
    return queue_.empty() && finished_.empty() &&
           std::ranges::all_of(slots_, [](const auto& slot) { return slot.empty(); });
  }

  std::uint32_t threads() const override { return static_cast<std::uint32_t>(slots_.size()); }

 private:
  std::vector<Task> next(const std::stop_token& stop, std::size_t slot) {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, stop, [&] { return !queue_.empty(); });
    if (stop.stop_requested()) return {};
    const std::size_t count = std::min({chunk_, queue_.size(), 1 + queue_.size() / slots_.size()});
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < count; ++i) {
      slots_[slot].push_back({queue_.front().sweep, queue_.front().job});
      tasks.push_back(std::move(queue_.front()));
      queue_.pop_front();
    }
    return tasks;
  }

  void run(const std::stop_token& stop, std::size_t slot) {
    const auto engine = experiment::make_scalar_engine();
    while (!stop.stop_requested()) {
      std::vector<Task> tasks = next(stop, slot);
      if (tasks.empty()) continue;
      std::vector<experiment::Job> jobs;
      jobs.reserve(tasks.size());
      for (const auto& task : tasks) jobs.push_back(task.grid->job(task.job));
      const auto start = std::chrono::steady_clock::now();
      auto results = engine->run(jobs, stop);
      finish(slot, tasks, results, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      signal_->notify();
    }
  }

  void finish(std::size_t slot, std::vector<Task>& tasks, std::vector<experiment::BatchResult>& results,
              double seconds) {
    const std::scoped_lock lock(mutex_);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      finished_.push_back({std::move(tasks[i]), std::move(results[i])});
    }
    slots_[slot].clear();
    const double each = seconds / static_cast<double>(tasks.size());
    chunk_ = static_cast<std::size_t>(
        std::clamp(target_seconds / std::max(each, 1e-9), 1.0, static_cast<double>(most_jobs_at_once)));
  }

  std::shared_ptr<messaging::Signal> signal_;
  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  std::deque<Task> queue_;
  std::vector<FinishedTask> finished_;
  std::vector<std::vector<messaging::RunningJob>> slots_;  ///< what each thread computes
  std::size_t chunk_ = 1;
  std::vector<std::jthread> threads_;  ///< last: they end before what they use
};

}  // namespace

std::unique_ptr<JobExecutor> make_thread_pool(std::uint32_t threads, std::shared_ptr<messaging::Signal> signal) {
  return std::make_unique<ThreadPool>(threads, std::move(signal));
}

}  // namespace lamprey::worker
