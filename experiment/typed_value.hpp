#pragma once

// What the reader, the validator and the grid share; nobody else needs it.

#include "experiment/parameters.hpp"
#include "idl/sweep.pb.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace lamprey::experiment {

/// Why something is not a value of a parameter.
struct Refusal {
  std::string reason;
};
using TypedValue = std::variant<Value, Refusal>;

/// The value as the registry's row wants it: of its kind, within its range, one of its choices, a whole number made
/// real for a real parameter, −0 made 0, a schedule in its canonical text.
TypedValue typed_value(const Parameter& parameter, const idl::Value& value);

/// A range's step: a number of the parameter's kind above 0, not bound to the parameter's range.
TypedValue typed_step(const Parameter& parameter, const idl::Value& value);

/// "a whole number from 0 to 100 (%)", "one of all, one, some": what a parameter takes, for messages.
std::string allowed_values(const Parameter& parameter);

/// "steps uniform": a parameter and its value, for messages.
std::string setting_text(const Parameter& parameter, const Value& value);

/// Whether values of the kind can be counted up in steps.
bool is_number(ParameterKind kind);

/// The value that a text of a file or a command line stands for: a number if the parameter takes one and the text is
/// one in decimal, without leading zeros, which some YAML readers take for octal. Else the text as it is, for
/// typed_value to say what is allowed.
idl::Value value_of_text(ParameterKind kind, const std::string& text);

/// The nearest number of 15 significant digits: what one would write.
double rounded_to_15_digits(double value);

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
