#pragma once

#include "idl/sweep.pb.h"

#include <cstddef>
#include <string>
#include <vector>

namespace lamprey::experiment {

/// More lines than this are not given, but counted in the last one.
inline constexpr std::size_t maximum_differences = 20;

/// How two valid specifications differ, for people, in the order of a sweep file and under its names: "seed: 2006, now
/// 2007", "base.cycles: 1000, now 500", "grids[0].mutation_size: 25, 50, 75, 100, now 25, 50", "grids: 2, now 3". Empty
/// if and only if they are the same sweep: description and execution are no part of it, nor is the order of the base.
std::vector<std::string> differences(const idl::SweepSpecification& stored, const idl::SweepSpecification& given);

}  // namespace lamprey::experiment
