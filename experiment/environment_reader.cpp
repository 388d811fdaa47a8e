#include "experiment/environment_reader.hpp"

#include "experiment/schedule.hpp"
#include "experiment/sweep_validation.hpp"

namespace lamprey::experiment {

namespace {

using Kind = YamlNode::Kind;

constexpr std::string_view field = "environment";
constexpr std::string_view cycle_key = "at";

std::uint32_t read_cycle(const std::string& path, const YamlNode& change, FieldReader& fields) {
  const YamlNode* node = change.find(cycle_key);
  idl::Value value;
  if (node != nullptr && (node->kind == Kind::list || node->kind == Kind::mapping)) {
    fields.refuse(path, "takes a single value; this is " + kind_name(*node));
    return 0;
  }
  if (node != nullptr && node->kind == Kind::scalar) {
    if (node->quoted) {
      value.set_text(node->text);
    } else {
      value = value_of_text(ParameterKind::integer, node->text);
    }
  }
  const auto cycle = change_cycle(value);
  if (const auto* sound = std::get_if<std::uint32_t>(&cycle)) return *sound;
  fields.refuse(path, std::get<Refusal>(cycle).reason);
  return 0;
}

void read_setting(const std::string& path, const YamlEntry& entry, EnvironmentChange& change, FieldReader& fields) {
  const auto row = changeable_row(entry.key);
  if (const auto* refusal = std::get_if<Refusal>(&row)) {
    fields.place_key(path, entry);
    return fields.refuse(path, refusal->reason);
  }
  fields.place(path, entry.value);
  const Parameter& parameter = registry()[std::get<std::size_t>(row)];
  idl::Value value;
  fields.read_value(path, entry.value, &parameter, value);
  if (fields.any_refused_within(path)) return;
  auto typed = typed_value(parameter, value);
  if (const auto* refusal = std::get_if<Refusal>(&typed)) return fields.refuse(path, refusal->reason);
  change.values.emplace_back(std::get<std::size_t>(row), std::get<Value>(std::move(typed)));
}

EnvironmentChange read_change(const std::string& path, const YamlNode& node, FieldReader& fields) {
  EnvironmentChange change;
  if (node.kind != Kind::mapping) {
    fields.refuse(path, "a change is a mapping such as {at: 500, required_distance: 25}; this is " + kind_name(node));
    return change;
  }
  const std::string at = axis_path(path, cycle_key);
  if (const auto* cycle = node.find(cycle_key)) fields.place(at, *cycle);
  change.cycle = read_cycle(at, node, fields);
  for (const auto& entry : node.entries) {
    if (entry.key != cycle_key) read_setting(axis_path(path, entry.key), entry, change, fields);
  }
  if (change.values.empty() && !fields.any_refused_within(path)) {
    fields.refuse(path, "nothing changes at this cycle; leave it out, or name a parameter and its new value");
  }
  sort_values(change);
  return change;
}

}  // namespace

std::optional<std::string> read_environment(const YamlNode& node, FieldReader& fields) {
  const std::string path(field);
  if (node.kind != Kind::list) {
    fields.refuse(path, "takes a list of changes such as {at: 500, required_distance: 25}; this is " + kind_name(node));
    return std::nullopt;
  }
  if (node.items.empty()) fields.refuse(path, "has no changes; leave it out for an environment that never changes");
  if (node.items.size() > maximum_changes) {
    fields.refuse(path, "has " + std::to_string(node.items.size()) + " changes; at most " +
                            std::to_string(maximum_changes) + " are allowed");
    return std::nullopt;
  }
  Schedule schedule;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const std::string change_path = value_path(path, i);
    fields.place(change_path, node.items[i]);
    auto change = read_change(change_path, node.items[i], fields);
    if (!schedule.empty() && change.cycle != 0 && change.cycle <= schedule.back().cycle) {
      fields.refuse(axis_path(change_path, cycle_key),
                    "cycle " + std::to_string(change.cycle) + " does not come after cycle " +
                        std::to_string(schedule.back().cycle) + ": changes are written in the order of their cycles");
    }
    schedule.push_back(std::move(change));
  }
  if (fields.any_refused_within(path)) return std::nullopt;
  return schedule_text(schedule);
}

}  // namespace lamprey::experiment
