#include "experiment/parameters.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

namespace lamprey::experiment {

namespace {

const std::unordered_map<std::string_view, std::size_t>& rows_by_name() {
  static const auto rows = [] {
    std::unordered_map<std::string_view, std::size_t> result;
    for (std::size_t row = 0; row < registry().size(); ++row) result.emplace(registry()[row].name, row);
    return result;
  }();
  return rows;
}

/// The conditions of every row, looked up once: applies() is asked for every parameter of every job. Conditions ask for
/// earlier rows, so those of what they ask for are there when a row's turn comes.
const std::vector<std::vector<RowCondition>>& conditions_by_row() {
  static const auto conditions = [] {
    std::vector<std::vector<RowCondition>> result;
    for (const auto& parameter : registry()) {
      std::vector<RowCondition> all;
      const auto add = [&](const RowCondition& condition) {
        if (std::ranges::find(all, condition) == all.end()) all.push_back(condition);
      };
      for (const auto& condition : parameter.applies_when) {
        std::ranges::for_each(result.at(parameter_index(condition.parameter)), add);
      }
      for (const auto& condition : parameter.applies_when) {
        add({parameter_index(condition.parameter), condition.is, condition.values});
      }
      result.push_back(std::move(all));
    }
    return result;
  }();
  return conditions;
}

const std::vector<std::size_t>& rows_sorted_by_name() {
  static const auto rows = [] {
    std::vector<std::size_t> result(registry().size());
    std::iota(result.begin(), result.end(), std::size_t{0});
    std::ranges::sort(result, {}, [](std::size_t row) { return registry()[row].name; });
    return result;
  }();
  return rows;
}

const std::vector<Value>& defaults() {
  static const auto values = [] {
    std::vector<Value> result;
    for (const auto& parameter : registry()) result.push_back(parameter.default_value);
    return result;
  }();
  return values;
}

std::string json_string(std::string_view text) {
  constexpr std::string_view hex_digits = "0123456789abcdef";
  std::string json = "\"";
  for (const char character : text) {
    const auto byte = static_cast<unsigned char>(character);
    if (character == '"' || character == '\\') {
      json += {'\\', character};
    } else if (byte < 0x20) {
      json += "\\u00";
      json += {hex_digits[byte >> 4], hex_digits[byte & 15]};
    } else {
      json += character;
    }
  }
  return json + '"';
}

template <typename Number>
std::string number_text(Number number) {
  std::array<char, 32> text{};  // the longest double in shortest form has 24 characters, the longest int64 has 20
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

}  // namespace

std::string to_text(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return number_text(*integer);
  return number_text(std::get<double>(value));
}

const Parameter* find_parameter(std::string_view name) {
  const auto found = rows_by_name().find(name);
  return found == rows_by_name().end() ? nullptr : &registry()[found->second];
}

std::size_t parameter_index(std::string_view name) {
  const auto found = rows_by_name().find(name);
  if (found == rows_by_name().end()) throw std::out_of_range("no parameter is called " + std::string(name));
  return found->second;
}

bool RowCondition::holds(const Value& value) const {
  const auto* choice = std::get_if<std::string>(&value);
  const bool named = choice != nullptr && std::ranges::find(values, *choice) != values.end();
  return named == is;
}

std::span<const RowCondition> conditions_of(std::size_t row) {
  return conditions_by_row().at(row);
}

Parameters::Parameters() : values_(defaults()) {}

bool Parameters::applies(std::size_t row) const {
  return std::ranges::all_of(conditions_by_row()[row],
                             [&](const RowCondition& condition) { return condition.holds(values_[condition.row]); });
}

std::string to_json(const Parameters& parameters) {
  std::string json = "{";
  for (std::size_t row = 0; row < registry().size(); ++row) {
    if (!parameters.applies(row)) continue;
    if (json.size() > 1) json += ',';
    json += json_string(registry()[row].name) + ':';
    const auto* text = std::get_if<std::string>(&parameters[row]);
    json += text != nullptr ? json_string(*text) : to_text(parameters[row]);
  }
  return json + '}';
}

std::string canonical_text(const Parameters& parameters) {
  std::string text;
  for (const std::size_t row : rows_sorted_by_name()) {
    if (parameters[row] == defaults()[row] || !parameters.applies(row)) continue;
    text.append(registry()[row].name).append("=").append(to_text(parameters[row])).append("\n");
  }
  return text;
}

}  // namespace lamprey::experiment
