#include "worker/robot/robot_executor.hpp"

#include "experiment/job_run.hpp"
#include "experiment/models.hpp"
#include "worker/robot/robot_machine.hpp"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <spdlog/spdlog.h>
#include <stop_token>
#include <thread>
#include <utility>

namespace lamprey::worker {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class RobotExecutor final : public JobExecutor {
 public:
  RobotExecutor(messaging::Participant& participant, std::shared_ptr<messaging::Signal> signal,
                const RobotExecutorOptions& options)
      : options_(options),
        signal_(std::move(signal)),
        connection_(participant, options.robot, options.asker),
        thread_([this](const std::stop_token& stop) { run(stop); }) {}

  ~RobotExecutor() override { RobotExecutor::stop(); }

  std::size_t wanted() const override {
    const std::scoped_lock lock(mutex_);
    return claimed_ && queue_.empty() && !stopping_ ? 1 : 0;
  }

  void submit(std::vector<Task> tasks) override {
    const std::scoped_lock lock(mutex_);
    for (auto& task : tasks) queue_.push_back({std::move(task), Clock::now()});
    wake_.notify_all();
  }

  std::vector<FinishedTask> take_finished() override {
    const std::scoped_lock lock(mutex_);
    return std::exchange(finished_, {});
  }

  std::vector<messaging::Checkpoint> take_checkpoints() override { return {}; }

  std::vector<messaging::RunningJob> running() const override {
    const std::scoped_lock lock(mutex_);
    return running_ ? std::vector{*running_} : std::vector<messaging::RunningJob>{};
  }

  void drop(const Id128& database, std::uint64_t lease) override {
    const std::scoped_lock lock(mutex_);
    std::erase_if(queue_, [&](const Waiting& waiting) { return is_of(waiting.task, database, lease); });
  }

  void interrupt(const Id128& database, std::uint64_t lease) override {
    drop(database, lease);
    const std::scoped_lock lock(mutex_);
    if (present_ && is_of(*present_, database, lease)) job_stop_.request_stop();
  }

  void stop() override {
    {
      const std::scoped_lock lock(mutex_);
      stopping_ = true;
      queue_.clear();
      job_stop_.request_stop();
    }
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
  }

  bool idle() const override {
    const std::scoped_lock lock(mutex_);
    return queue_.empty() && finished_.empty() && !running_;
  }

  std::uint32_t threads() const override { return 1; }

  std::vector<std::string> labels() const override {
    const std::scoped_lock lock(mutex_);
    const std::string label(messaging::robot_label);
    std::vector<std::string> labels{label + "=" + options_.robot};
    if (claimed_) labels.push_back(label);
    return labels;
  }

 private:
  struct Waiting {
    Task task;
    Clock::time_point submitted;
  };

  static bool is_of(const Task& task, const Id128& database, std::uint64_t lease) {
    return task.database == database && task.lease == lease;
  }

  void run(const std::stop_token& stop) {
    std::string said;
    while (!stop.stop_requested()) {
      const bool claimed = connection_.keep_claim(stop);
      if (!claimed && std::exchange(said, connection_.why_not()) != connection_.why_not()) {
        spdlog::info("robot {} is not to be had: {}; waiting", options_.robot, connection_.why_not());
      }
      offer(claimed);
      auto next = next_task(stop);
      if (next) finish(std::move(*next));
    }
    offer(false);
    connection_.release({});
  }

  void offer(bool claimed) {
    {
      const std::scoped_lock lock(mutex_);
      if (std::exchange(claimed_, claimed) == claimed) return;
      if (!claimed) give_back_queue();
    }
    signal_->notify();
  }

  /// Under the mutex.
  void give_back_queue() {
    for (auto& waiting : std::exchange(queue_, {})) {
      finished_.push_back({std::move(waiting.task), {.identity = {}, .result = experiment::Interrupted{}}});
    }
  }

  std::optional<Waiting> next_task(const std::stop_token& stop) {
    constexpr std::chrono::milliseconds between_looks{100};
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, stop, between_looks, [&] { return !queue_.empty(); });
    if (stop.stop_requested() || queue_.empty()) return std::nullopt;
    Waiting next = std::move(queue_.front());
    queue_.pop_front();
    job_stop_ = std::stop_source();
    present_ = next.task;
    running_ = messaging::RunningJob{next.task.sweep, next.task.job};
    return next;
  }

  void finish(Waiting next) {
    const auto start = Clock::now();
    FinishedTask finished{.task = std::move(next.task),
                          .result = {.identity = {}, .result = experiment::Interrupted{}}};
    finished.waited = std::chrono::duration<double>(start - next.submitted).count();
    finished.task.checkpoint.clear();
    const auto job = finished.task.grid->job(finished.task.job);
    finished.result.identity = experiment::identity(job);
    Recorder recorder(options_.robot, connection_.token());
    try {
      finished.result.result = outcome(job, recorder, finished.task.time_limit, start);
    } catch (const JobGivenBack&) {
      spdlog::info("job {} goes back: the robot is away, or this worker stops", job.number);
    } catch (const std::exception& error) {
      finished.result.result = experiment::Failure{error.what()};
    }
    finished.result.seconds = seconds_since(start);
    if (experiment::on_a_robot(job.parameters)) finished.recording = recorder.octets();
    {
      const std::scoped_lock lock(mutex_);
      finished_.push_back(std::move(finished));
      running_.reset();
      present_.reset();
    }
    signal_->notify();
  }

  std::variant<experiment::Outcome, experiment::Failure, experiment::Interrupted> outcome(const experiment::Job& job,
                                                                                          Recorder& recorder,
                                                                                          double time_limit,
                                                                                          Clock::time_point start) {
    const std::stop_token stop = job_stop_.get_token();
    RobotMachine robot(connection_, recorder, evaluations_, stop, options_.patience);
    experiment::JobRun run(job, experiment::on_a_robot(job.parameters) ? &robot : nullptr);
    while (!run.finished()) {
      if (stop.stop_requested()) return experiment::Interrupted{};
      if (time_limit > 0 && seconds_since(start) > time_limit) {
        return experiment::Failure{"exceeded its time limit of " + experiment::to_text(experiment::Value(time_limit)) +
                                   " s"};
      }
      run.advance(1);
      const std::scoped_lock lock(mutex_);
      running_->cycle = run.outcome().cycles;
      running_->seconds = seconds_since(start);
    }
    return std::move(run).take();
  }

  RobotExecutorOptions options_;
  std::shared_ptr<messaging::Signal> signal_;

  // Of the thread.
  RobotConnection connection_;
  std::uint64_t evaluations_ = 0;  ///< never less: a claim that was lost and found again goes on under its token

  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  std::deque<Waiting> queue_;
  std::vector<FinishedTask> finished_;
  std::optional<Task> present_;
  std::optional<messaging::RunningJob> running_;
  std::stop_source job_stop_;
  bool claimed_ = false;
  bool stopping_ = false;

  std::jthread thread_;
};

}  // namespace

std::unique_ptr<JobExecutor> make_robot_executor(messaging::Participant& participant,
                                                 std::shared_ptr<messaging::Signal> signal,
                                                 const RobotExecutorOptions& options) {
  return std::make_unique<RobotExecutor>(participant, std::move(signal), options);
}

}  // namespace lamprey::worker
