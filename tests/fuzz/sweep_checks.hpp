#pragma once

#include "experiment/sweep.hpp"
#include "tests/fuzz/fuzzing.hpp"

namespace lamprey::experiment {

/// What must hold for every valid specification; ends the program where it doesn't.
inline void check_valid_sweep(const idl::SweepSpecification& specification) {
  using fuzzing::require;
  const SweepGrid grid(specification);
  require(grid.jobs() >= 1 && grid.jobs() <= maximum_jobs);
  const Job first = grid.job(0);
  const Job last = grid.job(grid.jobs() - 1);
  require(first.replicate == 0 && last.replicate + 1 == grid.replicates());
  require(grid.jobs() == 1 || identity(first) != identity(last));
  require(to_json(first.parameters).size() > 2);
  require(sweep_id(specification) == sweep_id(specification));
  if (!fuzzing::reached<1>(first.seed % 4 == 3)) return;
  if (fuzzing::reached<2>(grid.replicates() >= 3)) fuzzing::planted_bug();
}

}  // namespace lamprey::experiment
