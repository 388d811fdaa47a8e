#include "experiment/parameters.hpp"

#include "client/commands/commands.hpp"
#include "client/failure.hpp"
#include "client/json.hpp"
#include "client/option_checks.hpp"
#include "client/output/formatting.hpp"
#include "client/output/table.hpp"
#include "experiment/schedule.hpp"

#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

using experiment::Parameter;
using experiment::ParameterKind;

struct Options {
  std::vector<std::string> names;
};

/// A bound of a number: whole ones as such.
experiment::Value bound(const Parameter& parameter, double value) {
  if (parameter.kind == ParameterKind::integer) return static_cast<std::int64_t>(value);
  return value;
}

std::vector<std::string> changeable_names() {
  std::vector<std::string> names;
  for (const std::size_t row : experiment::environment_rows()) names.emplace_back(experiment::registry()[row].name);
  return names;
}

std::string default_text(const Parameter& parameter) {
  const std::string text = experiment::to_text(parameter.default_value);
  return text.empty() ? "none" : text;
}

std::string range_text(const Parameter& parameter) {
  if (parameter.kind == ParameterKind::choice) {
    return output::joined({parameter.choices.begin(), parameter.choices.end()}, ", ");
  }
  if (parameter.kind == ParameterKind::schedule) {
    return "changes at cycles of " + output::joined(changeable_names(), ", ");
  }
  return experiment::to_text(bound(parameter, parameter.minimum)) + " to " +
         experiment::to_text(bound(parameter, parameter.maximum));
}

std::string applies_text(const Parameter& parameter) {
  std::string text;
  for (const auto& condition : parameter.applies_when) {
    if (!text.empty()) text += " and ";
    text += std::string(condition.parameter) + (condition.is ? " is " : " is not ") +
            output::joined({condition.values.begin(), condition.values.end()}, " or ");
  }
  return text.empty() ? "always" : text;
}

std::string kind_name(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::choice:
      return "choice";
    case ParameterKind::integer:
      return "integer";
    case ParameterKind::real:
      return "real";
    case ParameterKind::schedule:
      return "schedule";
  }
  return {};
}

Json json_of(const Parameter& parameter) {
  Json json = {{"name", parameter.name},
               {"meaning", parameter.meaning},
               {"unit", parameter.unit},
               {"kind", kind_name(parameter.kind)},
               {"default", as_json(parameter.default_value)}};
  if (parameter.kind == ParameterKind::choice) {
    json["choices"] = parameter.choices;
  } else if (parameter.kind == ParameterKind::schedule) {
    json["changes"] = changeable_names();
  } else {
    json["minimum"] = as_json(bound(parameter, parameter.minimum));
    json["maximum"] = as_json(bound(parameter, parameter.maximum));
  }
  json["applies_when"] = Json::array();
  for (const auto& condition : parameter.applies_when) {
    json["applies_when"].push_back(
        {{"parameter", condition.parameter}, {"is", condition.is}, {"values", condition.values}});
  }
  json["source"] = parameter.source;
  return json;
}

std::vector<const Parameter*> chosen(const std::vector<std::string>& names) {
  std::vector<const Parameter*> rows;
  std::vector<std::string_view> known;
  for (const auto& parameter : experiment::registry()) {
    known.push_back(parameter.name);
    if (names.empty()) rows.push_back(&parameter);
  }
  for (const auto& name : names) {
    const auto* parameter = experiment::find_parameter(name);
    if (parameter == nullptr) throw Failure(exit_usage, "unknown_parameter", unknown_name("parameter", name, known));
    rows.push_back(parameter);
  }
  return rows;
}

ExitCode parameters(const Options& options, const Context& context) {
  const auto rows = chosen(options.names);
  if (context.format == Format::json) {
    Json json = document("parameters", 2);
    json["science_version"] = experiment::science_version;
    json["parameters"] = Json::array();
    for (const auto* row : rows) json["parameters"].push_back(json_of(*row));
    print(context.console, json);
    return exit_ok;
  }
  output::Table table({{"name"}, {"default"}, {"unit"}, {"takes"}, {"applies when"}});
  for (const auto* row : rows) {
    table.add(
        {std::string(row->name), default_text(*row), std::string(row->unit), range_text(*row), applies_text(*row)});
    table.note(std::string(row->meaning) + " [" + std::string(row->source) + "]");
  }
  table.print(context.console);
  return exit_ok;
}

}  // namespace

Action declare_parameters(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Lists the parameters of experiments: name, default, unit, what it takes, when it applies, its meaning and, in "
      "brackets, where the thesis has it. These are the names in sweep files, on command lines and in the database.");
  app.add_option("NAME", options->names, "Only these parameters");
  return [options](const Context& context) { return parameters(*options, context); };
}

}  // namespace lamprey::client::commands
