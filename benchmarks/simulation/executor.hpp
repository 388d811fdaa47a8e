#pragma once

#include "worker/job_executor.hpp"
#include "worker/outbox.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace lamprey::benchmarks {

using worker::Clock;

/// A worker's only thread, under a clock that the simulation moves: each job takes `job_time` of it, whatever it takes
/// to compute. Outcomes are real, by `engine`; it and the clock outlive this object.
class SimulatedExecutor final : public worker::JobExecutor {
 public:
  SimulatedExecutor(experiment::BatchEngine& engine, const Clock::time_point& now, Clock::duration job_time)
      : engine_(engine), now_(now), job_time_(job_time) {}

  /// When the job that runs ends; nothing if none does.
  std::optional<Clock::time_point> next_end() const;
  /// Of the jobs that have ended.
  Clock::duration busy() const { return busy_; }

  std::size_t wanted() const override;
  void submit(std::vector<worker::Task> tasks) override;
  std::vector<worker::FinishedTask> take_finished() override;
  std::vector<messaging::Checkpoint> take_checkpoints() override { return {}; }
  std::vector<messaging::RunningJob> running() const override;
  void drop(const worker::Id128& database, std::uint64_t lease) override;
  void interrupt(const worker::Id128& database, std::uint64_t lease) override { drop(database, lease); }
  void stop() override { queue_.clear(); }
  bool idle() const override { return queue_.empty(); }
  std::uint32_t threads() const override { return 1; }

 private:
  struct Queued {
    worker::Task task;
    Clock::time_point end;
  };

  experiment::BatchEngine& engine_;
  const Clock::time_point& now_;
  Clock::duration job_time_;
  Clock::duration busy_{};
  std::deque<Queued> queue_;  ///< the first one runs
};

}  // namespace lamprey::benchmarks
