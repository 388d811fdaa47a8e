#include "client/commands/commands.hpp"
#include "client/failure.hpp"
#include "client/json.hpp"
#include "client/option_checks.hpp"
#include "client/output/formatting.hpp"
#include "client/output/table.hpp"
#include "experiment/job_run.hpp"
#include "experiment/sweep.hpp"

#include <charconv>
#include <memory>
#include <optional>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::vector<std::string> settings;
};

template <typename Number>
std::optional<Number> read(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The value as a sweep file would have it; text where it isn't of the parameter's kind, so that the validator can
/// say what is wrong with it.
idl::Value value_of(const experiment::Parameter& parameter, const std::string& text) {
  idl::Value value;
  if (parameter.kind != experiment::ParameterKind::choice) {
    if (const auto integer = read<std::int64_t>(text)) {
      value.set_integer(*integer);
      return value;
    }
    if (const auto real = read<double>(text)) {
      value.set_real(*real);
      return value;
    }
  }
  value.set_text(text);
  return value;
}

std::string parameter_unknown(const std::string& name) {
  std::vector<std::string_view> known;
  for (const auto& parameter : experiment::registry()) known.push_back(parameter.name);
  return unknown_name("parameter", name, known);
}

/// The settings go through the same validator as a sweep file's base.
experiment::Parameters parameters_of(const std::vector<std::string>& settings) {
  idl::SweepSpecification specification;
  specification.set_name("evaluate");
  specification.set_replicates(1);
  std::vector<std::string> problems;
  for (const auto& setting : settings) {
    const auto equals = setting.find('=');
    const std::string name = setting.substr(0, equals);
    const auto* parameter = experiment::find_parameter(name);
    if (equals == std::string::npos) {
      problems.push_back("'" + experiment::printable(setting) + "' is not of the form PARAMETER=VALUE");
    } else if (parameter == nullptr) {
      problems.push_back(parameter_unknown(name));
    } else {
      auto* base = specification.add_base();
      base->set_parameter(name);
      *base->mutable_value() = value_of(*parameter, setting.substr(equals + 1));
    }
  }
  for (const auto& problem : experiment::validate(specification)) {
    const auto& field = problem.field;
    problems.push_back((field.starts_with("base.") ? field.substr(5) : field) + ": " + problem.message);
  }
  if (!problems.empty()) throw Failure(exit_usage, "invalid_input", std::move(problems));
  return experiment::SweepGrid(specification).job(0).parameters;
}

ExitCode evaluate(const Options& options, const Context& context) {
  const auto parameters = parameters_of(options.settings);
  const auto score = experiment::evaluate_preset(parameters);
  if (context.format == Format::json) {
    Json json = document("evaluate");
    json.update(as_json(score));
    json["parameters"] = as_json(parameters);
    print(context.console, json);
    return exit_ok;
  }
  using output::Align;
  const auto weight = [&](const char* parameter) { return std::to_string(parameters.integer(parameter)) + " %"; };
  output::Table table({{"fitness"}, {"value", Align::right}, {"weight", Align::right}});
  table.add({"stability", output::shortest(score.stability), weight("required_stability")});
  table.add({"distance", output::shortest(score.distance), weight("required_distance")});
  table.add({"fuel", output::shortest(score.fuel), weight("required_fuel")});
  table.add({"total", output::shortest(score.total), ""});
  table.print(context.console);
  return exit_ok;
}

}  // namespace

Action declare_evaluate(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Lets the robot walk once with its undisturbed gait, from standing, and shows the fitness: stability, distance, "
      "fuel that remains, and their weighted total.");
  app.add_option("PARAMETER=VALUE", options->settings,
                 "Parameters that differ from their defaults; 'lamprey parameters' lists them");
  app.footer("Example\n  lamprey evaluate gait=walk required_fuel=50");
  return [options](const Context& context) { return evaluate(*options, context); };
}

}  // namespace lamprey::client::commands
