#pragma once

#include "experiment/job.hpp"
#include "experiment/outcome.hpp"

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

namespace lamprey::experiment {

/// A job that ended without an outcome although its parameters are valid: a defect, or a resource that was missing.
struct Failure {
  std::string reason;
};

/// The job was not finished because a stop was requested. It has no effect; run it again.
struct Interrupted {};

struct BatchResult {
  Digest identity{};
  std::variant<Outcome, Failure, Interrupted> result;
  double seconds = 0;  ///< of computation; not deterministic, not part of the digest
};

/// Runs jobs. The scalar engine is the reference; others run many jobs side by side and must give the same bits.
/// An outcome never depends on the other jobs of the batch.
class BatchEngine {
 public:
  virtual ~BatchEngine() = default;

  /// How many jobs at once suit this engine best (1 for the scalar one).
  virtual std::size_t preferred_batch() const = 0;

  /// One result per job, in order. Called from one thread at a time per engine; make an engine for each thread.
  /// A requested stop is honoured within a few milliseconds.
  virtual std::vector<BatchResult> run(std::span<const Job> jobs, std::stop_token stop) = 0;
};

/// The plain engine: one job after another, no SIMD, exactly the models of science/.
std::unique_ptr<BatchEngine> make_scalar_engine();

}  // namespace lamprey::experiment
