#pragma once

#include "experiment/parameters.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace lamprey::experiment {

/// `count` different values of a whole or real parameter, evenly distributed from `from` up to and including `to`
/// (from <= to, of its kind), in ascending order; nothing if there are not that many. They depend on the seed and on
/// the parameter's name, so a parameter has the same sample in every grid of a sweep. The i-th draw is the leading 53
/// bits of SHA-256 over "lamprey-sample/1\nseed=<seed>\nparameter=<name>\ndraw=<i>\n", as a share of 1.
/// Whole numbers: R. W. Floyd's algorithm (J. Bentley, Programming pearls: a sample of brilliance, CACM 30, 1987).
/// Real numbers are rounded to 15 significant digits; repeated ones are drawn anew.
std::optional<std::vector<Value>> axis_sample(const Parameter& parameter, std::uint64_t seed, std::uint64_t count,
                                              const Value& from, const Value& to);

}  // namespace lamprey::experiment
