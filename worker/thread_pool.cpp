#include "experiment/checkpoint.hpp"
#include "worker/job_executor.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <iterator>
#include <limits>
#include <mutex>
#include <spdlog/spdlog.h>
#include <stop_token>
#include <thread>
#include <unistd.h>
#include <utility>
#include <variant>

namespace lamprey::worker {

namespace {

using Clock = std::chrono::steady_clock;
using experiment::Assignment;
using experiment::BatchResult;
using experiment::Progress;

/// Computation that one handing-over should amount to: long against its cost, short against a heartbeat.
constexpr double target_seconds = 0.02;
constexpr std::size_t most_jobs_at_once = 1024;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

struct Waiting {
  Task task;
  Clock::time_point submitted;
};

bool is_of(const Task& task, const Id128& database, std::uint64_t lease) {
  return task.database == database && task.lease == lease;
}

void erase_lease(std::deque<Waiting>& tasks, const Id128& database, std::uint64_t lease) {
  std::erase_if(tasks, [&](const Waiting& waiting) { return is_of(waiting.task, database, lease); });
}

messaging::Checkpoint checkpoint_of(const Task& task, const experiment::CheckpointHead& head,
                                    std::vector<std::uint8_t> state) {
  messaging::Checkpoint checkpoint;
  checkpoint.origin.database = task.database;
  checkpoint.sweep = task.sweep;
  checkpoint.job = task.job;
  checkpoint.lease = task.lease;
  checkpoint.cycle = head.cycle;
  checkpoint.seconds = head.seconds;
  checkpoint.identity = head.identity;
  checkpoint.state = std::move(state);
  return checkpoint;
}

/// Where an interrupted job can go on. A checkpoint that it came with and never used may be of no use.
std::optional<messaging::Checkpoint> checkpoint_of(const Task& task, BatchResult& result) {
  auto* interrupted = std::get_if<experiment::Interrupted>(&result.result);
  if (interrupted == nullptr || interrupted->checkpoint.empty()) return std::nullopt;
  try {
    const auto head = experiment::read_checkpoint_head(interrupted->checkpoint);
    return checkpoint_of(task, head, std::exchange(interrupted->checkpoint, {}));
  } catch (const experiment::CheckpointError&) {
    return std::nullopt;
  }
}

/// What one thread has in hand, and what it watches while its engine runs. A task is either waiting in its chunk, in
/// the batch or finished. Its own thread moves tasks on; any thread may ask.
class Hand final : public experiment::BatchWatcher {
 public:
  /// `relieve` is called, by the thread of this hand, when others should have what waits behind a long job.
  Hand(double checkpoint_interval, std::shared_ptr<messaging::Signal> signal, std::function<void(Hand&)> relieve)
      : checkpoint_interval_(checkpoint_interval), signal_(std::move(signal)), relieve_(std::move(relieve)) {}

  void take(std::deque<Waiting> chunk) {
    const std::scoped_lock lock(mutex_);
    chunk_ = std::move(chunk);
    chunk_began_ = Clock::now();
  }

  /// Moves up to `count` tasks from the chunk to the batch; none: the chunk is done.
  std::span<const Assignment> begin_batch(std::size_t count) {
    const std::scoped_lock lock(mutex_);
    batch_.clear();
    const auto now = Clock::now();
    for (; count > 0 && !chunk_.empty(); --count) {
      Waiting& next = chunk_.front();
      Task& task = next.task;
      batch_.push_back({.job = task.grid->job(task.job),
                        .checkpoint = std::exchange(task.checkpoint, {}),
                        .time_limit = task.time_limit});
      running_.push_back({.task = std::move(task), .waited = seconds_between(next.submitted, now)});
      chunk_.pop_front();
    }
    return batch_;
  }

  void end_batch(std::vector<BatchResult> results) {
    std::vector<FinishedTask> ended;
    for (std::size_t i = 0; i < results.size(); ++i) {
      // Only this thread changes what is running, so it may read it unlocked.
      const Running& running = running_[i];
      auto checkpoint = checkpoint_of(running.task, results[i]);
      ended.push_back({running.task, std::move(results[i]), running.waited, std::move(checkpoint)});
    }
    const std::scoped_lock lock(mutex_);
    std::ranges::move(ended, std::back_inserter(finished_));
    running_.clear();
  }

  /// Whether its thread should hand over what it has finished and what it has not begun.
  bool overdue() const {
    const std::scoped_lock lock(mutex_);
    return is_overdue(Clock::now());
  }

  struct Load {
    std::vector<FinishedTask> finished;
    std::deque<Waiting> waiting;
    double seconds = 0;  ///< since the last one
  };
  Load hand_over() {
    const std::scoped_lock lock(mutex_);
    const auto now = Clock::now();
    return {std::exchange(finished_, {}), std::exchange(chunk_, {}),
            seconds_between(std::exchange(chunk_began_, now), now)};
  }

  void drop(const Id128& database, std::uint64_t lease) {
    const std::scoped_lock lock(mutex_);
    erase_lease(chunk_, database, lease);
  }

  void interrupt(const Id128& database, std::uint64_t lease) {
    const std::scoped_lock lock(mutex_);
    erase_lease(chunk_, database, lease);
    for (auto& running : running_) {
      if (is_of(running.task, database, lease)) running.interrupt = true;
    }
  }

  void add_running(std::vector<messaging::RunningJob>& jobs) const {
    const std::scoped_lock lock(mutex_);
    for (const auto& running : running_) {
      jobs.push_back({running.task.sweep, running.task.job, running.progress.cycle, running.progress.seconds});
    }
  }

  void take_checkpoints(std::vector<messaging::Checkpoint>& checkpoints) {
    const std::scoped_lock lock(mutex_);
    for (auto& running : running_) {
      if (running.newest) checkpoints.push_back(*std::exchange(running.newest, std::nullopt));
    }
  }

  bool empty() const {
    const std::scoped_lock lock(mutex_);
    return chunk_.empty() && running_.empty() && finished_.empty();
  }

  Order look(std::size_t job, const Progress& progress) override {
    if (overdue()) relieve_(*this);
    const std::scoped_lock lock(mutex_);
    Running& running = running_[job];
    if (!std::exchange(running.begun, true)) running.checkpoint_due = progress.seconds + checkpoint_interval_;
    running.progress = progress;
    if (running.interrupt) return Order::interrupt;
    if (progress.seconds < running.checkpoint_due) return Order::go_on;
    running.checkpoint_due = progress.seconds + checkpoint_interval_;
    return Order::save;
  }

  void saved(std::size_t job, const Progress& progress, std::vector<std::uint8_t> checkpoint) override {
    {
      const std::scoped_lock lock(mutex_);
      Running& running = running_[job];
      if (checkpoint.empty()) {
        running.checkpoint_due = std::numeric_limits<double>::infinity();
        return;
      }
      const experiment::CheckpointHead head{
          .identity = experiment::identity(batch_[job].job), .cycle = progress.cycle, .seconds = progress.seconds};
      running.newest = checkpoint_of(running.task, head, std::move(checkpoint));
    }
    signal_->notify();
  }

  void begins_anew(std::size_t job, const std::string& reason) override {
    const Task& task = running_[job].task;
    spdlog::warn("job {} of sweep {} begins anew, its checkpoint is of no use: {}", task.job,
                 experiment::to_hex(task.sweep), reason);
  }

 private:
  struct Running {
    Task task;
    double waited = 0;
    Progress progress{};
    bool interrupt = false;
    bool begun = false;
    double checkpoint_due = 0;  ///< in seconds of its progress
    std::optional<messaging::Checkpoint> newest{};
  };

  bool is_overdue(Clock::time_point now) const {
    return !(chunk_.empty() && finished_.empty()) && seconds_between(chunk_began_, now) > target_seconds;
  }

  double checkpoint_interval_;
  std::shared_ptr<messaging::Signal> signal_;
  std::function<void(Hand&)> relieve_;
  mutable std::mutex mutex_;
  std::deque<Waiting> chunk_;
  std::vector<Assignment> batch_;  ///< of its own thread
  std::vector<Running> running_;   ///< the tasks of the batch
  std::vector<FinishedTask> finished_;
  Clock::time_point chunk_began_;
};

/// A mutex of the pool and one of each hand; whoever needs both locks the pool's first. A task that goes from the queue
/// to a hand, or back, does so under both.
class ThreadPool final : public JobExecutor {
 public:
  ThreadPool(std::uint32_t threads, std::shared_ptr<messaging::Signal> signal, double checkpoint_interval, int nice)
      : signal_(std::move(signal)), nice_(nice) {
    for (std::uint32_t i = 0; i < std::max(threads, 1U); ++i) {
      hands_.push_back(
          std::make_unique<Hand>(checkpoint_interval, signal_, [this](Hand& hand) { take_over_from(hand); }));
    }
    for (const auto& hand : hands_) {
      threads_.emplace_back([this, &own = *hand](const std::stop_token& stop) { run(stop, own); });
    }
  }

  ~ThreadPool() override { ThreadPool::stop(); }

  void stop() override {
    {
      const std::scoped_lock lock(mutex_);
      stopping_ = true;
      queue_.clear();
    }
    for (auto& thread : threads_) thread.request_stop();
    threads_.clear();  // joins
  }

  std::size_t wanted() const override {
    const std::scoped_lock lock(mutex_);
    const std::size_t target = 2 * hands_.size() * chunk_;
    return target - std::min(target, queue_.size());
  }

  void submit(std::vector<Task> tasks) override {
    {
      const std::scoped_lock lock(mutex_);
      const auto now = Clock::now();
      for (auto& task : tasks) queue_.push_back({std::move(task), now});
    }
    wake_.notify_all();
  }

  std::vector<FinishedTask> take_finished() override {
    const std::scoped_lock lock(mutex_);
    return std::exchange(finished_, {});
  }

  std::vector<messaging::Checkpoint> take_checkpoints() override {
    std::vector<messaging::Checkpoint> checkpoints;
    for (const auto& hand : hands_) hand->take_checkpoints(checkpoints);
    return checkpoints;
  }

  std::vector<messaging::RunningJob> running() const override {
    std::vector<messaging::RunningJob> jobs;
    for (const auto& hand : hands_) hand->add_running(jobs);
    return jobs;
  }

  void drop(const Id128& database, std::uint64_t lease) override {
    const std::scoped_lock lock(mutex_);
    erase_lease(queue_, database, lease);
    for (const auto& hand : hands_) hand->drop(database, lease);
  }

  void interrupt(const Id128& database, std::uint64_t lease) override {
    const std::scoped_lock lock(mutex_);
    erase_lease(queue_, database, lease);
    for (const auto& hand : hands_) hand->interrupt(database, lease);
  }

  bool idle() const override {
    const std::scoped_lock lock(mutex_);
    return queue_.empty() && finished_.empty() &&
           std::ranges::all_of(hands_, [](const auto& hand) { return hand->empty(); });
  }

  std::uint32_t threads() const override { return static_cast<std::uint32_t>(hands_.size()); }

 private:
  /// Waits for work and gives the hand its share.
  void fill(const std::stop_token& stop, Hand& hand) {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, stop, [&] { return !queue_.empty(); });
    if (stop.stop_requested()) return;
    const std::size_t count = std::min({chunk_, queue_.size(), 1 + queue_.size() / hands_.size()});
    const auto end = queue_.begin() + static_cast<std::ptrdiff_t>(count);
    hand.take({std::move_iterator(queue_.begin()), std::move_iterator(end)});
    queue_.erase(queue_.begin(), end);
  }

  void run(const std::stop_token& stop, Hand& hand) {
    // Of this thread alone, on Linux. More of it is always granted.
    if (nice_ > 0) static_cast<void>(::nice(nice_));
    const auto engine = experiment::make_scalar_engine();
    while (!stop.stop_requested()) {
      fill(stop, hand);
      while (!stop.stop_requested()) {
        const auto batch = hand.begin_batch(engine->preferred_batch());
        if (batch.empty()) break;
        hand.end_batch(engine->run(batch, hand, stop));
        if (hand.overdue()) take_over_from(hand);
      }
      take_over_from(hand);
    }
  }

  /// What the hand has finished can be taken; what it has not begun waits for any thread.
  void take_over_from(Hand& hand) {
    {
      const std::scoped_lock lock(mutex_);
      Hand::Load load = hand.hand_over();
      // A hand that just was relieved may have nothing, which says nothing.
      if (!load.finished.empty() || load.seconds > target_seconds) {
        const auto jobs = static_cast<double>(std::max<std::size_t>(load.finished.size(), 1));
        chunk_ = static_cast<std::size_t>(std::clamp(target_seconds * jobs / std::max(load.seconds, 1e-9), 1.0,
                                                     static_cast<double>(most_jobs_at_once)));
      }
      std::ranges::move(load.finished, std::back_inserter(finished_));
      if (!stopping_) std::move(load.waiting.rbegin(), load.waiting.rend(), std::front_inserter(queue_));
    }
    wake_.notify_all();
    signal_->notify();
  }

  std::shared_ptr<messaging::Signal> signal_;
  int nice_;
  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  std::deque<Waiting> queue_;
  std::vector<FinishedTask> finished_;
  std::size_t chunk_ = 1;
  bool stopping_ = false;
  std::vector<std::unique_ptr<Hand>> hands_;  ///< one for each thread
  std::vector<std::jthread> threads_;         ///< last: they end before what they use
};

}  // namespace

std::unique_ptr<JobExecutor> make_thread_pool(std::uint32_t threads, std::shared_ptr<messaging::Signal> signal,
                                              std::chrono::duration<double> checkpoint_interval, int nice) {
  return std::make_unique<ThreadPool>(threads, std::move(signal), checkpoint_interval.count(), nice);
}

}  // namespace lamprey::worker
