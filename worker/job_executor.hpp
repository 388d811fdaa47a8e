#pragma once

#include "experiment/batch_engine.hpp"
#include "experiment/sweep.hpp"
#include "messaging/port.hpp"
#include "messaging/samples.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamprey::worker {

using experiment::Id128;

/// A job of a lease, on its way through the executor.
struct Task {
  Id128 database;
  Id128 sweep;
  std::uint64_t lease = 0;
  std::uint64_t job = 0;
  std::shared_ptr<const experiment::SweepGrid> grid{};  ///< the job's parameters are expanded where it runs
  /// Where it goes on (experiment/checkpoint.hpp); empty: from its beginning, as where it can't be used.
  std::vector<std::uint8_t> checkpoint{};
  double time_limit = 0;  ///< seconds of computation, over all attempts that checkpoints join; 0: any
};

struct FinishedTask {
  Task task;  ///< without its checkpoint
  experiment::BatchResult result;
  double waited = 0;  ///< seconds from submit to start
  /// Of an interrupted job that need not begin anew. The origin has the database only.
  std::optional<messaging::Checkpoint> checkpoint{};
  std::vector<std::uint8_t> recording{};  ///< idl::RobotRecording, of a job on a robot
};

/// Computes jobs beside the worker's protocol. Called from the protocol's thread only.
class JobExecutor {
 public:
  virtual ~JobExecutor() = default;

  /// How many jobs more it wants now, to stay busy until it is asked again.
  virtual std::size_t wanted() const = 0;
  virtual void submit(std::vector<Task> tasks) = 0;
  /// Jobs that have ended since the last call, done, failed or interrupted; never blocks.
  virtual std::vector<FinishedTask> take_finished() = 0;
  /// The newest checkpoint of each job that runs, unless it was taken before. The origin has the database only.
  virtual std::vector<messaging::Checkpoint> take_checkpoints() = 0;
  /// Being computed at this moment.
  virtual std::vector<messaging::RunningJob> running() const = 0;
  /// Gives back the lease's jobs that have not started.
  virtual void drop(const Id128& database, std::uint64_t lease) = 0;
  /// The same, and ends those that run as soon as may be: they come back as interrupted.
  virtual void interrupt(const Id128& database, std::uint64_t lease) = 0;
  /// Stops for good: drops what is queued, interrupts what runs, returns when nothing runs any more. What had ended and
  /// what was interrupted can still be taken.
  virtual void stop() = 0;
  /// What it can offer at this moment besides computing, as labels.
  virtual std::vector<std::string> labels() const { return {}; }
  /// Neither queued nor running nor finished and not taken.
  virtual bool idle() const = 0;
  virtual std::uint32_t threads() const = 0;
};

/// How long a job runs until its first checkpoint, and then to each further one.
inline constexpr std::chrono::duration<double> default_checkpoint_interval{2};

/// One engine on each of `threads` threads (at least 1); `signal` is notified when jobs have ended and when there are
/// checkpoints to take. `nice` is added to the niceness of these threads alone, so that a worker that yields to others
/// is still heard in time. Destroying it stops it.
std::unique_ptr<JobExecutor> make_thread_pool(
    std::uint32_t threads, std::shared_ptr<messaging::Signal> signal,
    std::chrono::duration<double> checkpoint_interval = default_checkpoint_interval, int nice = 0);

}  // namespace lamprey::worker
