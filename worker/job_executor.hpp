#pragma once

#include "experiment/batch_engine.hpp"
#include "experiment/sweep.hpp"
#include "messaging/port.hpp"
#include "messaging/samples.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace lamprey::worker {

using experiment::Id128;

/// A job of a lease, on its way through the executor.
struct Task {
  Id128 database;
  Id128 sweep;
  std::uint64_t lease = 0;
  std::uint64_t job = 0;
  std::shared_ptr<const experiment::SweepGrid> grid;  ///< the job's parameters are expanded where it runs
};

struct FinishedTask {
  Task task;
  experiment::BatchResult result;
};

/// Computes jobs beside the worker's protocol. Called from the protocol's thread only.
class JobExecutor {
 public:
  virtual ~JobExecutor() = default;

  /// How many jobs more it wants now, to stay busy until it is asked again.
  virtual std::size_t wanted() const = 0;
  virtual void submit(std::vector<Task> tasks) = 0;
  /// Jobs that have ended since the last call; never blocks.
  virtual std::vector<FinishedTask> take_finished() = 0;
  /// Being computed at this moment.
  virtual std::vector<messaging::RunningJob> running() const = 0;
  /// Gives back the lease's jobs that have not started.
  virtual void drop(const Id128& database, std::uint64_t lease) = 0;
  /// Stops for good: drops what is queued, interrupts what runs, returns when nothing runs any more. What had ended can
  /// still be taken.
  virtual void stop() = 0;
  /// Neither queued nor running nor finished and not taken.
  virtual bool idle() const = 0;
  virtual std::uint32_t threads() const = 0;
};

/// One engine on each of `threads` threads (at least 1); `signal` is notified when jobs have ended.
/// Destroying it stops it.
std::unique_ptr<JobExecutor> make_thread_pool(std::uint32_t threads, std::shared_ptr<messaging::Signal> signal);

}  // namespace lamprey::worker
