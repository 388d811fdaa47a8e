#include "client/commands/commands.hpp"
#include "client/json.hpp"
#include "client/output/formatting.hpp"
#include "client/output/table.hpp"
#include "client/parameter_settings.hpp"
#include "experiment/job_run.hpp"

#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::vector<std::string> settings;
};

ExitCode evaluate(const Options& options, const Context& context) {
  const auto parameters = parameters_of_settings(options.settings);
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
