#include "experiment/execution_reader.hpp"

#include "experiment/execution_validation.hpp"
#include "experiment/sweep_validation.hpp"
#include "experiment/typed_value.hpp"

#include <array>
#include <charconv>
#include <optional>

namespace lamprey::experiment {

namespace {

using Kind = YamlNode::Kind;
using Labels = google::protobuf::RepeatedPtrField<std::string>;

constexpr std::array<std::string_view, 8> fields_of_execution = {
    "priority", "max_concurrent", "time_limit", "attempts", "fail_fast", "stop_when", "needs", "tags"};

std::optional<std::int64_t> whole_number(const YamlNode& node) {
  if (node.kind != Kind::scalar || node.quoted) return std::nullopt;
  const auto value = value_of_text(ParameterKind::integer, node.text);
  if (value.has_integer()) return value.integer();
  return std::nullopt;
}

std::optional<double> real_number(const YamlNode& node) {
  if (node.kind != Kind::scalar || node.quoted) return std::nullopt;
  const auto value = value_of_text(ParameterKind::real, node.text);
  if (value.has_real()) return value.real();
  if (value.has_integer()) return static_cast<double>(value.integer());
  return std::nullopt;
}

std::string not_allowed(const YamlNode& node, const std::string& field, const std::string& takes) {
  return kind_name(node) + " is not allowed: " + field + " takes " + takes;
}

/// A whole number in the range, or nothing after that has been refused.
std::optional<std::int64_t> read_whole(const YamlEntry& entry, std::int64_t minimum, std::int64_t maximum,
                                       const std::string& takes, FieldReader& fields) {
  const auto value = whole_number(entry.value);
  if (value && *value >= minimum && *value <= maximum) return value;
  fields.refuse(entry.key, not_allowed(entry.value, entry.key, takes));
  return std::nullopt;
}

void read_time_limit(const YamlEntry& entry, FieldReader& fields, idl::Execution& execution) {
  const auto value = real_number(entry.value);
  if (value && *value > 0 && *value <= maximum_time_limit) return execution.set_time_limit(*value);
  fields.refuse(entry.key, not_allowed(entry.value, entry.key, time_limit_takes()));
}

void read_fail_fast(const YamlEntry& entry, FieldReader& fields, idl::Execution& execution) {
  const auto& node = entry.value;
  const bool is_true = node.text == "true";
  if (node.kind != Kind::scalar || node.quoted || (!is_true && node.text != "false")) {
    return fields.refuse(entry.key, not_allowed(node, entry.key, "true or false"));
  }
  execution.set_fail_fast(is_true);
}

void read_stop_when(const YamlEntry& entry, FieldReader& fields, idl::Execution& execution) {
  const auto& node = entry.value;
  if (node.kind != Kind::mapping) {
    return fields.refuse(entry.key,
                         "takes a mapping of measures to values, such as {failed: 10}; this is " + kind_name(node));
  }
  if (node.entries.empty()) return fields.refuse(entry.key, "has no measures; leave it out");
  for (const auto& condition : node.entries) {
    const std::string path = axis_path(entry.key, condition.key);
    const auto value = real_number(condition.value);
    auto& added = *execution.add_stop_when();
    added.set_measure(condition.key);
    // Whether there is such a measure is for the validator to say, at its name.
    const auto& known = stop_measures();
    if (std::find(known.begin(), known.end(), condition.key) == known.end()) {
      fields.place_key(path, condition);
      continue;
    }
    fields.place(path, condition.value);
    if (value) {
      added.set_at_least(*value);
    } else {
      fields.refuse(path, not_allowed(condition.value, condition.key, stop_measure_takes(condition.key)));
    }
  }
}

/// One text, or a list of texts.
void read_labels(const YamlEntry& entry, std::string_view what, FieldReader& fields, Labels& labels) {
  const auto add = [&](const std::string& path, const YamlNode& node) {
    fields.place(path, node);
    if (node.kind != Kind::scalar) return fields.refuse(path, "takes text; this is " + kind_name(node));
    *labels.Add() = node.text;
  };
  if (entry.value.kind != Kind::list) {
    if (entry.value.kind == Kind::scalar) return add(value_path(entry.key, 0), entry.value);
    return fields.refuse(entry.key, "takes a list of " + std::string(what) + "s; this is " + kind_name(entry.value));
  }
  for (std::size_t i = 0; i < entry.value.items.size(); ++i) add(value_path(entry.key, i), entry.value.items[i]);
}

}  // namespace

std::span<const std::string_view> execution_fields() {
  return fields_of_execution;
}

void read_execution_field(const YamlEntry& entry, FieldReader& fields, idl::Execution& execution) {
  if (entry.key == "priority") {
    if (const auto value = read_whole(entry, minimum_priority, maximum_priority, priority_takes(), fields)) {
      execution.set_priority(static_cast<std::int32_t>(*value));
    }
  } else if (entry.key == "max_concurrent") {
    if (const auto value = read_whole(entry, 1, maximum_concurrent_jobs, max_concurrent_takes(), fields)) {
      execution.set_max_concurrent(static_cast<std::uint32_t>(*value));
    }
  } else if (entry.key == "time_limit") {
    read_time_limit(entry, fields, execution);
  } else if (entry.key == "attempts") {
    if (const auto value = read_whole(entry, 1, maximum_attempts, attempts_takes(), fields)) {
      execution.set_attempts(static_cast<std::uint32_t>(*value));
    }
  } else if (entry.key == "fail_fast") {
    read_fail_fast(entry, fields, execution);
  } else if (entry.key == "stop_when") {
    read_stop_when(entry, fields, execution);
  } else if (entry.key == "needs") {
    read_labels(entry, "label", fields, *execution.mutable_needs());
  } else {
    read_labels(entry, "tag", fields, *execution.mutable_tags());
  }
}

}  // namespace lamprey::experiment
