#include "experiment/sweep_grid.hpp"

#include "experiment/sweep.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

namespace lamprey::experiment {

namespace {

std::string shown(const idl::Value& value) {
  switch (value.kind_case()) {
    case idl::Value::kInteger:
      return to_text(Value(std::int64_t{value.integer()}));
    case idl::Value::kReal:
      return to_text(Value(value.real()));
    case idl::Value::kText:
      return "'" + printable(value.text()) + "'";
    case idl::Value::KIND_NOT_SET:
      break;
  }
  return "nothing";
}

template <typename Number>
bool reads_as(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

/// A number that was put into quotes.
bool is_quoted_number(ParameterKind kind, const idl::Value& value) {
  if (value.kind_case() != idl::Value::kText || kind == ParameterKind::choice) return false;
  return kind == ParameterKind::integer ? reads_as<std::int64_t>(value.text()) : reads_as<double>(value.text());
}

/// The number, if the value is one of the kind that the parameter takes. −0 becomes 0.
std::optional<Value> number_of_kind(ParameterKind kind, const idl::Value& value) {
  if (kind == ParameterKind::integer) {
    if (value.kind_case() != idl::Value::kInteger) return std::nullopt;
    return Value(std::int64_t{value.integer()});
  }
  if (value.kind_case() == idl::Value::kInteger) return Value(static_cast<double>(value.integer()));
  if (value.kind_case() != idl::Value::kReal || !std::isfinite(value.real())) return std::nullopt;
  return Value(value.real() == 0 ? 0.0 : value.real());
}

double as_double(const Value& value) {
  const auto* integer = std::get_if<std::int64_t>(&value);
  return integer != nullptr ? static_cast<double>(*integer) : std::get<double>(value);
}

Refusal wrong_kind(const Parameter& parameter, const idl::Value& value, const std::string& allowed) {
  const std::string takes = ": " + std::string(parameter.name) + " takes " + allowed;
  if (value.kind_case() == idl::Value::KIND_NOT_SET) return {"no value is given" + takes};
  if (is_quoted_number(parameter.kind, value)) {
    return {shown(value) + " is text" + takes + "; write the number without quotes and leading zeros"};
  }
  const char* wanted = parameter.kind == ParameterKind::integer ? " is not a whole number" : " is not a number";
  return {shown(value) + (parameter.kind == ParameterKind::choice ? " is not a name" : wanted) + takes};
}

TypedValue typed_choice(const Parameter& parameter, const idl::Value& value) {
  if (value.kind_case() != idl::Value::kText) return wrong_kind(parameter, value, allowed_values(parameter));
  if (std::ranges::find(parameter.choices, value.text()) != parameter.choices.end()) return Value(value.text());
  Refusal refusal{shown(value) + " is not known: " + std::string(parameter.name) + " takes " +
                  allowed_values(parameter)};
  const std::string nearest = nearest_name(value.text(), parameter.choices);
  if (!nearest.empty()) refusal.reason += "; did you mean '" + nearest + "'?";
  return refusal;
}

/// The i-th value of a range of real numbers.
double real_range_value(double from, double to, double step, std::uint64_t i) {
  if (i == 0) return from;
  const double exact = from + static_cast<double>(i) * step;
  constexpr int significant_digits = 15;
  std::array<char, 40> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), exact, std::chars_format::general, significant_digits).ptr;
  double rounded = 0;
  std::from_chars(text.data(), end, rounded);
  return std::min(rounded, to);
}

NumberRange typed_range(const Parameter& parameter, const idl::Range& range) {
  return {std::get<Value>(typed_value(parameter, range.from())), std::get<Value>(typed_value(parameter, range.to())),
          std::get<Value>(typed_step(parameter, range.step()))};
}

/// The values of an axis of a valid specification.
std::vector<Value> axis_values(const Parameter& parameter, const idl::Axis& axis) {
  if (axis.has_range()) return range_values(typed_range(parameter, axis.range()));
  std::vector<Value> values;
  values.reserve(static_cast<std::size_t>(axis.values_size()));
  for (const auto& value : axis.values()) values.push_back(std::get<Value>(typed_value(parameter, value)));
  return values;
}

void require_valid(const idl::SweepSpecification& specification) {
  auto problems = validate(specification);
  if (!problems.empty()) throw InvalidInput(std::move(problems));
}

/// One line of a grid in the canonical text; the grammar is in docs/formats/sweep_file.md.
std::string canonical_axis(const Parameter& parameter, const idl::Axis& axis) {
  std::string text;
  if (axis.has_range()) {
    const NumberRange range = typed_range(parameter, axis.range());
    text = to_text(range.from) + ".." + to_text(range.to) + "/" + to_text(range.step);
  } else {
    for (const auto& value : axis_values(parameter, axis)) text += (text.empty() ? "" : ",") + to_text(value);
  }
  return std::string(parameter.name) + "=" + text + "\n";
}

}  // namespace

std::string allowed_values(const Parameter& parameter) {
  std::string text;
  if (parameter.kind == ParameterKind::choice) {
    for (const auto choice : parameter.choices) text.append(text.empty() ? "" : ", ").append(choice);
    return parameter.choices.size() > 1 ? "one of " + text : "only " + text;
  }
  if (parameter.kind == ParameterKind::integer) {
    text = "a whole number from " + to_text(Value(static_cast<std::int64_t>(parameter.minimum))) + " to " +
           to_text(Value(static_cast<std::int64_t>(parameter.maximum)));
  } else {
    text = "a number from " + to_text(Value(parameter.minimum)) + " to " + to_text(Value(parameter.maximum));
  }
  return parameter.unit.empty() ? text : text + " (" + std::string(parameter.unit) + ")";
}

TypedValue typed_value(const Parameter& parameter, const idl::Value& value) {
  if (parameter.kind == ParameterKind::choice) return typed_choice(parameter, value);
  const auto number = number_of_kind(parameter.kind, value);
  if (!number) return wrong_kind(parameter, value, allowed_values(parameter));
  if (as_double(*number) < parameter.minimum || as_double(*number) > parameter.maximum) {
    return Refusal{to_text(*number) + " is out of range: " + std::string(parameter.name) + " takes " +
                   allowed_values(parameter)};
  }
  return *number;
}

TypedValue typed_step(const Parameter& parameter, const idl::Value& value) {
  const std::string allowed =
      parameter.kind == ParameterKind::integer ? "steps of a whole number above 0" : "steps of a number above 0";
  const auto number = number_of_kind(parameter.kind, value);
  if (!number) return wrong_kind(parameter, value, allowed);
  if (as_double(*number) <= 0) {
    return Refusal{to_text(*number) + " is out of range: " + std::string(parameter.name) + " takes " + allowed};
  }
  return *number;
}

std::uint64_t range_size(const NumberRange& range) {
  constexpr std::uint64_t huge = 1'000'000'000'000'000'000;
  if (const auto* from = std::get_if<std::int64_t>(&range.from)) {
    // Both ends are within a parameter's range, so their difference is far from overflow.
    const auto span = static_cast<std::uint64_t>(std::get<std::int64_t>(range.to) - *from);
    return span / static_cast<std::uint64_t>(std::get<std::int64_t>(range.step)) + 1;
  }
  constexpr double missing_share_of_step = 1e-9;
  const double steps = (as_double(range.to) - as_double(range.from)) / as_double(range.step) + missing_share_of_step;
  return steps < static_cast<double>(huge) ? static_cast<std::uint64_t>(steps) + 1 : huge;
}

std::vector<Value> range_values(const NumberRange& range) {
  const std::uint64_t size = range_size(range);
  std::vector<Value> values;
  values.reserve(size);
  for (std::uint64_t i = 0; i < size; ++i) {
    if (const auto* from = std::get_if<std::int64_t>(&range.from)) {
      values.emplace_back(*from + static_cast<std::int64_t>(i) * std::get<std::int64_t>(range.step));
    } else {
      values.emplace_back(real_range_value(as_double(range.from), as_double(range.to), as_double(range.step), i));
    }
  }
  return values;
}

SweepGrid::SweepGrid(const idl::SweepSpecification& specification)
    : seed_(specification.seed()), replicates_(specification.replicates()) {
  require_valid(specification);
  for (const auto& setting : specification.base()) {
    const std::size_t row = parameter_index(setting.parameter());
    base_.set(row, std::get<Value>(typed_value(registry()[row], setting.value())));
  }
  for (const auto& grid : specification.grids()) {
    Grid& expanded = grids_.emplace_back();
    for (const auto& axis : grid.axes()) {
      const std::size_t row = parameter_index(axis.parameter());
      expanded.axes.push_back({row, axis_values(registry()[row], axis)});
      expanded.cells *= expanded.axes.back().values.size();
    }
  }
  // Without grids the base is the only cell.
  if (grids_.empty()) grids_.emplace_back();
  for (const auto& grid : grids_) cells_ += grid.cells;
}

Job SweepGrid::job(std::uint64_t number) const {
  if (number >= jobs()) {
    throw std::out_of_range("job " + std::to_string(number) + " of a sweep of " + std::to_string(jobs()) + " jobs");
  }
  Job job{
      .number = number, .seed = seed_, .replicate = static_cast<std::uint32_t>(number / cells_), .parameters = base_};
  std::uint64_t cell = number % cells_;
  auto grid = grids_.begin();
  for (; cell >= grid->cells; ++grid) cell -= grid->cells;
  for (auto axis = grid->axes.rbegin(); axis != grid->axes.rend(); ++axis) {
    job.parameters.set(axis->parameter, axis->values[cell % axis->values.size()]);
    cell /= axis->values.size();
  }
  return job;
}

Id128 sweep_id(const idl::SweepSpecification& specification) {
  require_valid(specification);
  std::map<std::string, std::string> base;
  for (const auto& setting : specification.base()) {
    const Parameter& parameter = *find_parameter(setting.parameter());
    base.emplace(parameter.name, to_text(std::get<Value>(typed_value(parameter, setting.value()))));
  }
  std::string text = "lamprey-sweep/1\nname=" + specification.name() +
                     "\nseed=" + std::to_string(specification.seed()) +
                     "\nreplicates=" + std::to_string(specification.replicates()) + "\nbase\n";
  for (const auto& [name, value] : base) text += name + "=" + value + "\n";
  for (const auto& grid : specification.grids()) {
    text += "grid\n";
    for (const auto& axis : grid.axes()) text += canonical_axis(*find_parameter(axis.parameter()), axis);
  }
  return leading_128_bits(sha256(text));
}

}  // namespace lamprey::experiment
