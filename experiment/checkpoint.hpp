#pragma once

#include "experiment/job.hpp"
#include "experiment/job_run.hpp"
#include "experiment/outcome.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace lamprey::experiment {

// A run between two steps of its trainer, as octets (docs/formats/checkpoint.md): whoever reads them, on any machine,
// goes on to the same outcome. The digest has no state of its own in them: it is computed at the end, over the whole
// outcome, whose trace so far is here. All functions may be called from any thread.

/// Larger than this, a run has no checkpoint: it must fit one message, with what goes with it.
inline constexpr std::size_t maximum_checkpoint_bytes = std::size_t{15} * 1024 * 1024;

/// Why octets are no checkpoint, or not one of this job by this program; the job begins anew.
class CheckpointError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `seconds` of computation so far. Empty if there is none: the run is finished, its trainer can't be saved, or it is
/// too large.
std::vector<std::uint8_t> write_checkpoint(const JobRun& run, const Job& job, double seconds);

struct Resumed {
  JobRun run;
  double seconds = 0;  ///< of computation before the checkpoint
};

/// Goes on with the job. Throws CheckpointError; besides what JobRun throws for the job itself.
Resumed resume(const Job& job, std::span<const std::uint8_t> checkpoint);

struct CheckpointHead {
  Digest identity{};        ///< of the job
  std::uint32_t cycle = 0;  ///< the number of cycles done
  double seconds = 0;       ///< of computation so far; finite, not negative
};

/// What can be told without the job; it is whole and of this format and science version. Throws CheckpointError.
CheckpointHead read_checkpoint_head(std::span<const std::uint8_t> checkpoint);

/// The trace so far: cycles ascend and have been done, scores are finite. Throws CheckpointError.
std::vector<AcceptedChange> read_checkpoint_trace(std::span<const std::uint8_t> checkpoint);

}  // namespace lamprey::experiment
