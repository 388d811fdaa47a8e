#pragma once

#include "experiment/parameters.hpp"
#include "idl/sweep.pb.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lamprey::experiment {

/// An axis of a grid that may apply in a part of it only.
struct ComposedAxis {
  /// The axis named before this one, and those of its values under which this one applies.
  struct Where {
    std::string parameter;
    std::vector<Value> values;  ///< sorted
  };

  idl::Axis axis;
  std::vector<Value> values;  ///< of a list: its values, bound to the registry's row
  std::vector<Where> where;   ///< all must hold; empty: applies wherever its grid does
};

/// What stands in a grid of a sweep file: an axis, or axes that advance together, as columns of equal length.
struct GridPart {
  std::vector<ComposedAxis> columns;
  bool zipped = false;
};

/// The plain grids that the parts stand for. Parts are gone through in order, and each row of a zip, and each group of
/// an axis's values that a later `where` tells apart, makes grids of its own; what stands first varies slowest. Groups
/// are in the order of their first values. A value of a referred axis is in or out of a `where` as a whole; an axis
/// that does not apply is left out, and then no `where` that refers to it holds.
/// Nothing if there would be more than `maximum_grids` of them or more than `maximum_values` values in them.
std::optional<std::vector<idl::Grid>> expanded(const std::vector<GridPart>& parts, std::size_t maximum_grids,
                                               std::uint64_t maximum_values);

}  // namespace lamprey::experiment
