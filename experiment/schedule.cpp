#include "experiment/schedule.hpp"

#include "experiment/problem.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace lamprey::experiment {

namespace {

constexpr std::array<std::string_view, 8> changeable = {
    "required_stability",      "required_distance",        "required_fuel",          "push_factor",
    "ground_level_front_left", "ground_level_front_right", "ground_level_back_left", "ground_level_back_right"};

constexpr std::string_view white_space = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(white_space);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(white_space) - begin + 1);
}

/// Takes the part before the separator, or all if there is none, off the text.
std::string_view take_until(std::string_view& text, std::string_view separators) {
  const auto end = std::min(text.find_first_of(separators), text.size());
  const auto part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

std::string quoted(std::string_view text) {
  return "'" + printable(text) + "'";
}

/// Adds a setting such as required_distance=25 to the change.
std::optional<Refusal> add_setting(EnvironmentChange& change, std::string_view setting) {
  const std::string at = "at cycle " + std::to_string(change.cycle) + ": ";
  const auto equals = setting.find('=');
  if (equals == std::string_view::npos) {
    return Refusal{at + quoted(setting) + " is not of the form PARAMETER=VALUE"};
  }
  const auto row = changeable_row(setting.substr(0, equals));
  if (const auto* refusal = std::get_if<Refusal>(&row)) return Refusal{at + refusal->reason};
  const Parameter& parameter = registry()[std::get<std::size_t>(row)];
  const auto value = typed_value(parameter, value_of_text(parameter.kind, std::string(setting.substr(equals + 1))));
  if (const auto* refusal = std::get_if<Refusal>(&value)) return Refusal{at + refusal->reason};
  for (const auto& [given, unused] : change.values) {
    if (given == std::get<std::size_t>(row)) return Refusal{at + std::string(parameter.name) + " is given twice"};
  }
  change.values.emplace_back(std::get<std::size_t>(row), std::get<Value>(value));
  return std::nullopt;
}

std::variant<EnvironmentChange, Refusal> checked_change(std::string_view text) {
  text = trimmed(text);
  if (text.empty()) return Refusal{"a change is missing beside a ';': a change is a cycle and what changes then"};
  const auto cycle = change_cycle(value_of_text(ParameterKind::integer, std::string(take_until(text, white_space))));
  if (const auto* refusal = std::get_if<Refusal>(&cycle)) return *refusal;
  EnvironmentChange change{.cycle = std::get<std::uint32_t>(cycle), .values = {}};
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    if (auto refusal = add_setting(change, take_until(text, white_space))) return *std::move(refusal);
  }
  if (change.values.empty()) {
    return Refusal{"nothing changes at cycle " + std::to_string(change.cycle) +
                   ": a change is a cycle and what changes then, such as '500 required_distance=25'"};
  }
  sort_values(change);
  return change;
}

}  // namespace

std::span<const std::size_t> environment_rows() {
  static const auto rows = [] {
    std::array<std::size_t, changeable.size()> result{};
    std::ranges::transform(changeable, result.begin(), parameter_index);
    std::ranges::sort(result);
    return result;
  }();
  return rows;
}

std::variant<std::size_t, Refusal> changeable_row(std::string_view name) {
  const auto found = std::ranges::find(changeable, name);
  if (found != changeable.end()) return parameter_index(*found);
  std::vector<std::string_view> known;
  for (const std::size_t row : environment_rows()) known.push_back(registry()[row].name);
  std::string reason =
      find_parameter(name) != nullptr ? quoted(name) + " cannot change in a run" : "unknown parameter " + quoted(name);
  if (const auto nearest = nearest_name(name, known); !nearest.empty()) {
    return Refusal{reason + "; did you mean '" + nearest + "'?"};
  }
  reason += "; what can change is";
  const char* joint = " ";
  for (const auto candidate : known) {
    reason.append(joint).append(candidate);
    joint = ", ";
  }
  return Refusal{reason};
}

std::variant<std::uint32_t, Refusal> change_cycle(const idl::Value& value) {
  const std::string takes = "a change begins at a cycle from 1 to " + std::to_string(maximum_change_cycle);
  if (value.kind_case() == idl::Value::KIND_NOT_SET) return Refusal{"no cycle is given: " + takes};
  if (value.kind_case() != idl::Value::kInteger) return Refusal{quoted(value.text()) + " is not a cycle: " + takes};
  if (value.integer() < 1 || value.integer() > maximum_change_cycle) {
    return Refusal{std::to_string(value.integer()) + " is out of range: " + takes};
  }
  return static_cast<std::uint32_t>(value.integer());
}

void sort_values(EnvironmentChange& change) {
  std::ranges::sort(change.values, {}, &std::pair<std::size_t, Value>::first);
}

std::variant<Schedule, Refusal> checked_schedule(std::string_view text) {
  Schedule schedule;
  std::string_view rest = trimmed(text);
  if (rest.empty()) return schedule;
  bool more = true;
  while (more) {
    if (schedule.size() == maximum_changes) {
      return Refusal{"has more than " + std::to_string(maximum_changes) + " changes"};
    }
    more = rest.find(';') != std::string_view::npos;
    auto change = checked_change(take_until(rest, ";"));
    if (auto* refusal = std::get_if<Refusal>(&change)) return std::move(*refusal);
    auto& next = std::get<EnvironmentChange>(change);
    if (!schedule.empty() && next.cycle <= schedule.back().cycle) {
      return Refusal{"cycle " + std::to_string(next.cycle) + " does not come after cycle " +
                     std::to_string(schedule.back().cycle) + ": changes are written in the order of their cycles"};
    }
    schedule.push_back(std::move(next));
  }
  return schedule;
}

Schedule parse_schedule(std::string_view text) {
  auto schedule = checked_schedule(text);
  if (auto* changes = std::get_if<Schedule>(&schedule)) return std::move(*changes);
  throw InvalidInput(Problem{.field = "environment", .message = std::get<Refusal>(schedule).reason, .file = ""});
}

std::string schedule_text(const Schedule& schedule) {
  std::string text;
  for (const auto& change : schedule) {
    if (!text.empty()) text += "; ";
    text += std::to_string(change.cycle);
    for (const auto& [row, value] : change.values) {
      text.append(" ").append(registry()[row].name).append("=").append(to_text(value));
    }
  }
  return text;
}

}  // namespace lamprey::experiment
