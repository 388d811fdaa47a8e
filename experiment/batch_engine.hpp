#pragma once

#include "experiment/job.hpp"
#include "experiment/outcome.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

namespace lamprey::experiment {

/// A job that ended without an outcome although its parameters are valid: a defect, a resource that was missing, or its
/// time limit.
struct Failure {
  std::string reason;
};

/// The job was not finished because a stop was requested. It has no effect; run it again.
struct Interrupted {
  std::vector<std::uint8_t> checkpoint{};  ///< where it can go on; empty: it begins anew
};

struct BatchResult {
  Digest identity{};
  std::variant<Outcome, Failure, Interrupted> result;
  /// Of computation, over all runs of the job that checkpoints join; not deterministic, not part of the digest.
  double seconds = 0;
};

/// A job as an engine is given it.
struct Assignment {
  Job job;
  std::vector<std::uint8_t> checkpoint{};  ///< where it goes on (checkpoint.hpp); empty: from its beginning
  double time_limit = 0;                   ///< seconds of computation, counted as in BatchResult; 0: any
};

/// How far a job is.
struct Progress {
  std::uint32_t cycle = 0;  ///< the number of cycles done
  double seconds = 0;       ///< of computation, counted as in BatchResult
};

/// Watches the jobs of a batch while they run. A job is named by its position in the batch. All calls come from the
/// thread that runs the batch.
class BatchWatcher {
 public:
  enum class Order : std::uint8_t { go_on, save, interrupt };

  virtual ~BatchWatcher() = default;

  /// Between two steps of a job that has begun: first before its first step, then every few milliseconds, sooner or
  /// later where a step takes longer. What is ordered has been done when it is asked again about this job.
  virtual Order look(std::size_t job, const Progress& progress) = 0;

  /// The checkpoint that was ordered by `save`; empty if the job has none: its trainer can't be saved, or it is too
  /// large. Then there is no use in ordering one again.
  virtual void saved(std::size_t job, const Progress& progress, std::vector<std::uint8_t> checkpoint) = 0;

  /// The job's checkpoint can't be used, for that reason; it begins anew.
  virtual void begins_anew(std::size_t job, const std::string& reason) = 0;
};

/// Runs jobs. The scalar engine is the reference; others run many jobs side by side and must give the same bits.
/// An outcome never depends on the other jobs of the batch, on checkpoints or on the watcher.
class BatchEngine {
 public:
  virtual ~BatchEngine() = default;

  /// How many jobs at once suit this engine best (1 for the scalar one).
  virtual std::size_t preferred_batch() const = 0;

  /// One result per job, in order. Called from one thread at a time per engine; make an engine for each thread.
  /// A requested stop, an order and a time limit are honoured between two steps of a trainer, within a few milliseconds
  /// where an evaluation takes no longer. A job that was interrupted before it began gives its own checkpoint back.
  virtual std::vector<BatchResult> run(std::span<const Assignment> batch, BatchWatcher& watcher,
                                       std::stop_token stop) = 0;

  /// The same from their beginnings, unwatched and without limits.
  std::vector<BatchResult> run(std::span<const Job> jobs, std::stop_token stop);
};

/// The plain engine: one job after another, no SIMD, exactly the models of science/.
std::unique_ptr<BatchEngine> make_scalar_engine();

}  // namespace lamprey::experiment
