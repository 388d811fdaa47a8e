#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lamprey::experiment {

/// The value of one parameter. Choices and schedules are text, whole numbers int64, real numbers double (always
/// finite).
using Value = std::variant<std::int64_t, double, std::string>;

/// The one textual form of a value: choices as they are, whole numbers in decimal, reals in the shortest form that
/// reads back to the same double (std::to_chars). Used in identities, JSON, tables and messages.
std::string to_text(const Value& value);

/// A schedule is text: changes of other parameters at given cycles (experiment/schedule.hpp).
enum class ParameterKind : std::uint8_t { choice, integer, real, schedule };

/// A parameter applies only where another one, a choice of an earlier row, has (or has not) one of some values:
/// mutation_size does not apply to the 1/5 rule. Where the other does not apply itself, neither does this.
struct Condition {
  std::string_view parameter;
  bool is = true;  ///< true: applies if the other is one of `values`; false: applies unless it is
  std::vector<std::string_view> values;
};

/// One row of the registry: help, validation, grid expansion, the results schema and every label derive from it.
struct Parameter {
  std::string_view name;     ///< the one spelling: in sweep files, on command lines, as a column of `result`
  std::string_view meaning;  ///< one sentence, in the field's terms
  std::string_view unit;     ///< empty where there is none
  ParameterKind kind;
  Value default_value;
  double minimum = 0;                     ///< for integer and real, inclusive
  double maximum = 0;                     ///< for integer and real, inclusive
  std::vector<std::string_view> choices;  ///< for choice
  std::string_view source;                ///< equation, figure or section of the thesis, or a decision record
  std::vector<Condition> applies_when;    ///< all must hold; empty: always applies
};

/// All parameters, in the order in which people read them (the order of columns and tables).
/// Thread-safe; the rows live as long as the program.
std::span<const Parameter> registry();

/// The row of that name, or nullptr.
const Parameter* find_parameter(std::string_view name);

/// A condition that must hold for a row's parameter to apply, with the parameter that it asks for looked up.
struct RowCondition {
  std::size_t row;
  bool is;
  std::vector<std::string_view> values;

  /// Whether it holds where that parameter, which applies, has the value.
  bool holds(const Value& value) const;

  bool operator==(const RowCondition&) const = default;
};

/// All conditions of a row: its own after those of the parameters that they ask for, none twice. The parameter applies
/// where all of them hold, each asked of the value alone. Thread-safe; they live as long as the program.
std::span<const RowCondition> conditions_of(std::size_t row);

/// Position of the row in registry(); throws std::out_of_range for an unknown name (a programming error: names from
/// users are checked with find_parameter).
std::size_t parameter_index(std::string_view name);

/// The value of every parameter of one job, by registry row. A value type; starts with all defaults.
class Parameters {
 public:
  Parameters();

  const Value& operator[](std::size_t row) const { return values_[row]; }
  void set(std::size_t row, Value value) { values_[row] = std::move(value); }

  /// By name; throws std::out_of_range for an unknown one, std::bad_variant_access for the wrong kind.
  const Value& get(std::string_view name) const { return values_[parameter_index(name)]; }
  std::int64_t integer(std::string_view name) const { return std::get<std::int64_t>(get(name)); }
  double real(std::string_view name) const { return std::get<double>(get(name)); }
  const std::string& choice(std::string_view name) const { return std::get<std::string>(get(name)); }
  void set(std::string_view name, Value value) { set(parameter_index(name), std::move(value)); }

  /// Whether the row's parameter applies, given the values of the others.
  bool applies(std::size_t row) const;

  bool operator==(const Parameters&) const = default;

 private:
  std::vector<Value> values_;
};

/// {"name":value,…} of the parameters that apply, in registry order, without white space: the column job.parameters.
std::string to_json(const Parameters& parameters);

/// `name=value\n` of the parameters that apply and differ from their defaults, sorted by name: what identities hash.
std::string canonical_text(const Parameters& parameters);

}  // namespace lamprey::experiment
