#pragma once

#include "experiment/field_reader.hpp"

#include <string>
#include <vector>

namespace lamprey::experiment {

/// Reads the field `grids` of a sweep file into the specification, whose seed is known. Grids with a `zip`, a `where`
/// or a `sample` become the plain grids that they stand for, or none where they could not be read. `grid_paths`: of
/// each grid of the specification, the grid of the file that it comes from.
void read_grids(const YamlNode& node, FieldReader& fields, idl::SweepSpecification& specification,
                std::vector<std::string>& grid_paths);

}  // namespace lamprey::experiment
