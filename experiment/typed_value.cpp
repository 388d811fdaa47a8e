#include "experiment/typed_value.hpp"

#include "experiment/problem.hpp"
#include "experiment/schedule.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

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
std::optional<Number> parse_number(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

bool looks_octal(std::string_view text) {
  const auto digits = text.starts_with('-') ? text.substr(1) : text;
  return digits.size() > 1 && digits[0] == '0' && digits[1] >= '0' && digits[1] <= '9';
}

/// A number that was put into quotes, or has leading zeros.
bool is_number_as_text(ParameterKind kind, const idl::Value& value) {
  if (value.kind_case() != idl::Value::kText) return false;
  return kind == ParameterKind::integer ? parse_number<std::int64_t>(value.text()).has_value()
                                        : parse_number<double>(value.text()).has_value();
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
  switch (parameter.kind) {
    case ParameterKind::choice:
      return {shown(value) + " is not a name" + takes};
    case ParameterKind::schedule:
      return {shown(value) + " is not text" + takes};
    case ParameterKind::integer:
    case ParameterKind::real:
      break;
  }
  if (is_number_as_text(parameter.kind, value)) {
    return {shown(value) + " is text" + takes + "; write the number without quotes and leading zeros"};
  }
  const char* wanted = parameter.kind == ParameterKind::integer ? " is not a whole number" : " is not a number";
  return {shown(value) + wanted + takes};
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

TypedValue typed_schedule(const Parameter& parameter, const idl::Value& value) {
  if (value.kind_case() != idl::Value::kText) return wrong_kind(parameter, value, allowed_values(parameter));
  const auto schedule = checked_schedule(value.text());
  if (const auto* changes = std::get_if<Schedule>(&schedule)) return Value(schedule_text(*changes));
  return std::get<Refusal>(schedule);
}

/// The i-th value of a range of real numbers.
double real_range_value(double from, double to, double step, std::uint64_t i) {
  if (i == 0) return from;
  return std::min(rounded_to_15_digits(from + static_cast<double>(i) * step), to);
}

}  // namespace

std::string setting_text(const Parameter& parameter, const Value& value) {
  const bool quoted = parameter.kind == ParameterKind::schedule;
  return std::string(parameter.name) + " " + (quoted ? "'" + printable(to_text(value)) + "'" : to_text(value));
}

bool is_number(ParameterKind kind) {
  return kind == ParameterKind::integer || kind == ParameterKind::real;
}

idl::Value value_of_text(ParameterKind kind, const std::string& text) {
  idl::Value value;
  const bool number = is_number(kind) && !looks_octal(text);
  const auto integer = number ? parse_number<std::int64_t>(text) : std::nullopt;
  const auto real = number && kind == ParameterKind::real ? parse_number<double>(text) : std::nullopt;
  if (real) {
    value.set_real(*real);
  } else if (integer) {
    value.set_integer(*integer);
  } else {
    value.set_text(text);
  }
  return value;
}

std::string allowed_values(const Parameter& parameter) {
  std::string text;
  if (parameter.kind == ParameterKind::choice) {
    for (const auto choice : parameter.choices) text.append(text.empty() ? "" : ", ").append(choice);
    return parameter.choices.size() > 1 ? "one of " + text : "only " + text;
  }
  if (parameter.kind == ParameterKind::schedule) {
    return "changes at cycles, such as '500 required_distance=25; 1000 required_distance=100', or ''";
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
  if (parameter.kind == ParameterKind::schedule) return typed_schedule(parameter, value);
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

double rounded_to_15_digits(double value) {
  constexpr int significant_digits = 15;
  std::array<char, 40> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, significant_digits).ptr;
  double rounded = 0;
  std::from_chars(text.data(), end, rounded);
  return rounded;
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

}  // namespace lamprey::experiment
