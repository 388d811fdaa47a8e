#include "robot_bridge/calibration_fields.hpp"

#include "experiment/field_reader.hpp"
#include "experiment/typed_value.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace lamprey::robot_bridge {

using experiment::kind_name;
using experiment::Problem;
using experiment::YamlEntry;
using experiment::YamlNode;
using Kind = YamlNode::Kind;

std::string joined(const Names& names) {
  std::string text;
  for (const auto name : names) text.append(text.empty() ? "" : ", ").append(name);
  return text;
}

std::string number_text(double number) {
  std::array<char, 400> text{};  // the largest number has 309 digits, the smallest some 340 decimals
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed).ptr};
}

std::optional<double> number_of(const YamlNode& node) {
  if (node.kind != Kind::scalar || node.quoted) return std::nullopt;
  const auto value = experiment::value_of_text(experiment::ParameterKind::real, node.text);
  if (!value.has_real() || !std::isfinite(value.real())) return std::nullopt;
  return value.real() == 0 ? 0.0 : value.real();
}

void CalibrationFields::refuse(int line, int column, const std::string& field, std::string message) {
  if (problems_.size() >= experiment::maximum_problems) return;
  problems_.push_back({.field = field, .message = std::move(message), .file = file_, .line = line, .column = column});
}

void CalibrationFields::refuse_unknown(const YamlEntry& entry, const std::string& holder, std::string_view what,
                                       const Names& known) {
  const std::string name = experiment::printable(entry.key);
  const std::string hint = experiment::nearest_hint(entry.key, known);
  refuse(entry.line, entry.column, holder.empty() ? name : holder + "." + name,
         "unknown " + std::string(what) + " '" + name + "'" + (hint.empty() ? "; known are " + joined(known) : hint));
}

void CalibrationFields::throw_if_any() {
  if (problems_.empty()) return;
  std::ranges::stable_sort(problems_, {}, [](const Problem& p) { return std::pair(p.line, p.column); });
  throw experiment::InvalidInput(problems_);
}

bool CalibrationFields::is_mapping(const YamlNode& node, const std::string& field, const std::string& takes) {
  if (node.kind == Kind::mapping) return true;
  refuse(node, field, "takes a mapping of " + takes + "; this is " + kind_name(node));
  return false;
}

std::optional<double> CalibrationFields::read_number(const YamlNode& node, const std::string& field, double lowest,
                                                     double highest, const std::string& unit, bool whole) {
  const auto number = number_of(node);
  if (number && *number >= lowest && *number <= highest && (!whole || *number == std::floor(*number))) return number;
  refuse(node, field,
         kind_name(node) + " is not allowed; it takes a " + (whole ? "whole number" : "number") + " from " +
             number_text(lowest) + " to " + number_text(highest) + unit);
  return std::nullopt;
}

std::optional<std::int32_t> CalibrationFields::read_whole(const YamlNode& node, const std::string& field,
                                                          std::int32_t lowest, std::int32_t highest) {
  const auto number = read_number(node, field, lowest, highest, "", true);
  if (!number) return std::nullopt;
  return static_cast<std::int32_t>(*number);
}

std::optional<double> CalibrationFields::read_positive(const YamlNode& node, const std::string& field, double highest,
                                                       const std::string& unit) {
  const auto number = number_of(node);
  if (number && *number > 0 && *number <= highest) return number;
  refuse(node, field,
         kind_name(node) + " is not allowed; it takes a number above 0, up to " + number_text(highest) + unit);
  return std::nullopt;
}

std::optional<std::size_t> CalibrationFields::read_choice(const YamlNode& node, const std::string& field,
                                                          const Names& known) {
  const auto found = std::ranges::find(known, node.text);
  if (node.kind == Kind::scalar && found != known.end()) return static_cast<std::size_t>(found - known.begin());
  const std::string hint = node.kind == Kind::scalar ? experiment::nearest_hint(node.text, known) : "";
  refuse(node, field, kind_name(node) + " is not allowed; it takes one of " + joined(known) + hint);
  return std::nullopt;
}

}  // namespace lamprey::robot_bridge
