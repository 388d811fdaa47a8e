#pragma once

#include "experiment/job.hpp"
#include "experiment/problem.hpp"
#include "idl/sweep.pb.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace lamprey::experiment {

/// More jobs than this in one sweep are refused: a slip in a range, not an experiment.
inline constexpr std::uint64_t maximum_jobs = 100'000'000;

/// Where each field of a specification stands in the file that it was read from; keys are Problem::field paths.
struct SourcePosition {
  int line = 0;
  int column = 0;
};
using SourceMap = std::map<std::string, SourcePosition>;

struct SweepFile {
  idl::SweepSpecification specification;
  SourceMap positions;
};

/// Reads and validates a sweep file. Throws InvalidInput naming file, line, field, value and range.
SweepFile read_sweep_file(const std::string& path);

/// The same from text; `file` is only used in messages.
SweepFile parse_sweep(const std::string& yaml, const std::string& file);

/// Everything that can be wrong with a specification, whoever sent it; empty if it is valid. The coordinator calls it
/// for what arrives from the network, the client for what it has read.
std::vector<Problem> validate(const idl::SweepSpecification& specification);

/// The jobs of a valid specification, expanded one at a time: nothing proportional to their number is held.
/// Job numbers count replicate by replicate, within it grid by grid, within it with the last axis fastest; so more
/// replicates or a further grid leave the numbers of the first replicate's earlier grids alone.
/// Immutable after construction; may be shared between threads.
class SweepGrid {
 public:
  /// Throws InvalidInput if validate() finds anything.
  explicit SweepGrid(const idl::SweepSpecification& specification);

  struct Axis {
    std::size_t parameter;  ///< row of the registry
    std::vector<Value> values;
  };
  struct Grid {
    std::vector<Axis> axes;
    std::uint64_t cells = 1;
  };

  std::uint64_t jobs() const { return cells_ * replicates_; }
  std::uint64_t cells() const { return cells_; }
  std::uint32_t replicates() const { return replicates_; }
  const std::vector<Grid>& grids() const { return grids_; }

  /// The job of that number, with defaults where a parameter does not apply; throws std::out_of_range unless
  /// number < jobs().
  Job job(std::uint64_t number) const;

  /// Whether any of its jobs may have to be on a robot (`robot: bridge`).
  bool asks_for_robot() const;

 private:
  Parameters base_;
  std::vector<Grid> grids_;
  std::uint64_t cells_ = 0;
  std::uint64_t seed_ = 0;
  std::uint32_t replicates_ = 1;
};

/// Names a sweep everywhere: the first 128 bits of SHA-256 over the specification's canonical text
/// (docs/formats/sweep_file.md), so that submitting the same sweep twice names the same sweep.
Id128 sweep_id(const idl::SweepSpecification& specification);

}  // namespace lamprey::experiment
