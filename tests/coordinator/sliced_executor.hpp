#pragma once

#include "experiment/job_run.hpp"
#include "worker/job_executor.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace lamprey::tests {

/// Runs one job at a time, some cycles of it per step, on the caller's thread, and has a checkpoint after each step: a
/// worker of long jobs under a clock that only the test moves.
class SlicedExecutor final : public worker::JobExecutor {
 public:
  explicit SlicedExecutor(std::uint32_t cycles_per_step) : cycles_per_step_(cycles_per_step) {}

  std::uint64_t cycles_computed = 0;

  std::size_t wanted() const override { return queue_.empty() ? 1 : 0; }
  void submit(std::vector<worker::Task> tasks) override;
  std::vector<worker::FinishedTask> take_finished() override;
  std::vector<messaging::Checkpoint> take_checkpoints() override;
  std::vector<messaging::RunningJob> running() const override;
  void drop(const experiment::Id128& database, std::uint64_t lease) override;
  void interrupt(const experiment::Id128& database, std::uint64_t lease) override;
  void stop() override;
  bool idle() const override { return !running_ && queue_.empty() && finished_.empty(); }
  std::uint32_t threads() const override { return 1; }

 private:
  struct Running {
    worker::Task task;
    experiment::Job job;
    experiment::JobRun run;
  };
  void begin(worker::Task task);
  std::optional<messaging::Checkpoint> checkpoint() const;
  void end_running();

  std::uint32_t cycles_per_step_;
  std::vector<worker::Task> queue_;
  std::optional<Running> running_;
  std::vector<worker::FinishedTask> finished_;
  bool advanced_ = false;
};

}  // namespace lamprey::tests
