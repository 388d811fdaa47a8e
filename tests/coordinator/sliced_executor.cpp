#include "tests/coordinator/sliced_executor.hpp"

#include "experiment/checkpoint.hpp"

#include <utility>

namespace lamprey::tests {

void SlicedExecutor::submit(std::vector<worker::Task> tasks) {
  for (auto& task : tasks) queue_.push_back(std::move(task));
}

void SlicedExecutor::begin(worker::Task task) {
  experiment::Job job = task.grid->job(task.job);
  auto run = task.checkpoint.empty() ? experiment::JobRun(job) : experiment::resume(job, task.checkpoint).run;
  running_.emplace(Running{std::move(task), std::move(job), std::move(run)});
}

std::vector<worker::FinishedTask> SlicedExecutor::take_finished() {
  if (!running_ && !queue_.empty()) {
    begin(std::move(queue_.front()));
    queue_.erase(queue_.begin());
  }
  if (running_) {
    const auto until = running_->run.outcome().cycles + cycles_per_step_;
    while (!running_->run.finished() && running_->run.outcome().cycles < until) {
      const auto before = running_->run.outcome().cycles;
      running_->run.advance();
      cycles_computed += running_->run.outcome().cycles - before;
    }
    advanced_ = true;
    if (running_->run.finished()) {
      auto& [task, job, run] = *running_;
      finished_.push_back({task, {experiment::identity(job), std::move(run).take()}});
      running_.reset();
    }
  }
  return std::exchange(finished_, {});
}

std::optional<messaging::Checkpoint> SlicedExecutor::checkpoint() const {
  const auto& [task, job, run] = *running_;
  messaging::Checkpoint checkpoint;
  checkpoint.state = experiment::write_checkpoint(run, job, 1);
  if (checkpoint.state.empty()) return std::nullopt;
  checkpoint.origin.database = task.database;
  checkpoint.sweep = task.sweep;
  checkpoint.job = task.job;
  checkpoint.lease = task.lease;
  checkpoint.cycle = run.outcome().cycles;
  checkpoint.seconds = 1;
  checkpoint.identity = experiment::identity(job);
  return checkpoint;
}

std::vector<messaging::Checkpoint> SlicedExecutor::take_checkpoints() {
  if (!running_ || !std::exchange(advanced_, false)) return {};
  auto taken = checkpoint();
  return taken ? std::vector{std::move(*taken)} : std::vector<messaging::Checkpoint>{};
}

std::vector<messaging::RunningJob> SlicedExecutor::running() const {
  if (!running_) return {};
  return {{running_->task.sweep, running_->task.job, running_->run.outcome().cycles, 1}};
}

void SlicedExecutor::drop(const experiment::Id128& database, std::uint64_t lease) {
  std::erase_if(queue_, [&](const auto& task) { return task.database == database && task.lease == lease; });
}

void SlicedExecutor::interrupt(const experiment::Id128& database, std::uint64_t lease) {
  drop(database, lease);
  if (running_ && running_->task.database == database && running_->task.lease == lease) end_running();
}

void SlicedExecutor::end_running() {
  if (!running_) return;
  finished_.push_back({running_->task, {experiment::identity(running_->job), experiment::Interrupted{}}});
  finished_.back().checkpoint = checkpoint();
  running_.reset();
}

void SlicedExecutor::stop() {
  queue_.clear();
  end_running();
}

}  // namespace lamprey::tests
