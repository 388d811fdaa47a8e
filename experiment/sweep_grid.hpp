#pragma once

// What the validator and the grid share; nobody else needs it.

#include "experiment/parameters.hpp"
#include "idl/sweep.pb.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace lamprey::experiment {

/// All axes of a sweep together hold at most this many values, so that their memory is bounded before it is taken.
inline constexpr std::uint64_t maximum_axis_values = 100'000;

/// Why something is not a value of a parameter.
struct Refusal {
  std::string reason;
};
using TypedValue = std::variant<Value, Refusal>;

/// The value as the registry's row wants it: of its kind, within its range, one of its choices, a whole number made
/// real for a real parameter, −0 made 0.
TypedValue typed_value(const Parameter& parameter, const idl::Value& value);

/// A range's step: a number of the parameter's kind above 0, not bound to the parameter's range.
TypedValue typed_step(const Parameter& parameter, const idl::Value& value);

/// "a whole number from 0 to 100 (%)", "one of all, one, some": what a parameter takes, for messages.
std::string allowed_values(const Parameter& parameter);

/// A range of a whole or real parameter whose parts have been typed.
struct NumberRange {
  Value from;
  Value to;
  Value step;
};

/// How many values a range with from <= to has; huge ones are given as 10¹⁸.
std::uint64_t range_size(const NumberRange& range);

/// from, from + step, … up to and including `to`. Real values are rounded to 15 significant digits, so that
/// 0 to 1 in steps of 0.1 has 0.3 and not 0.30000000000000004; `to` is met if a billionth of a step is missing.
std::vector<Value> range_values(const NumberRange& range);

}  // namespace lamprey::experiment
