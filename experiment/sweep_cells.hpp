#pragma once

// What it takes several fields of a specification to see; the validator's second half.

#include "experiment/parameters.hpp"
#include "experiment/problem.hpp"
#include "idl/sweep.pb.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lamprey::experiment {

/// The values that each parameter takes in one grid, by registry row: those of its axis, else the one of the base,
/// else the default. A grid is the Cartesian product of them.
struct GridValues {
  std::string path;  ///< of the grid in messages; several grids have the same if one of the file stands for them
  std::vector<std::vector<Value>> values;
  std::vector<bool> is_axis;
};

/// Notes axes that do not apply, settings that contradict each other, jobs that two grids share, settings of the base
/// that apply nowhere, and too many jobs. Grids about which something has been noted are left out, and what needs all
/// grids then too. The base must be in order.
void check_together(const idl::SweepSpecification& specification, std::vector<GridValues> grids, Findings& findings);

}  // namespace lamprey::experiment
