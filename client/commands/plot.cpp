#include "client/commands/commands.hpp"
#include "client/failure.hpp"
#include "client/json.hpp"
#include "client/option_checks.hpp"
#include "client/output/table.hpp"
#include "client/parameter_settings.hpp"
#include "client/plot/figure.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string figure;
  std::vector<std::string> arguments;
  std::string output;
  std::optional<std::string> sweep;
  std::vector<std::uint64_t> jobs;
  std::optional<std::string> average_by;
  std::optional<std::int64_t> cycles;
  std::int32_t time_steps = 0;
};

ExitCode list(const Context& context) {
  if (context.format == Format::json) {
    Json json = document("plot");
    json["figures"] = Json::array();
    for (const auto& figure : plot::figure_table()) {
      json["figures"].push_back({{"figure", figure.name},
                                 {"summary", figure.summary},
                                 {"needs_database", figure.source == plot::Source::results}});
    }
    print(context.console, json);
    return exit_ok;
  }
  output::Table table({{"figure"}, {"drawn from"}, {"what it shows"}});
  for (const auto& figure : plot::figure_table()) {
    table.add({std::string(figure.name), figure.source == plot::Source::results ? "DATABASE" : "parameters",
               std::string(figure.summary)});
  }
  table.print(context.console);
  return exit_ok;
}

const plot::Figure& require_figure(const std::string& name) {
  if (const auto* figure = plot::find_figure(name)) return *figure;
  std::vector<std::string_view> known = {"list"};
  for (const auto& figure : plot::figure_table()) known.push_back(figure.name);
  throw Failure(exit_usage, "unknown_figure", unknown_name("figure", name, known));
}

/// The database, which has no '=' in its name, among the arguments after the figure; the others are settings.
std::optional<std::string> take_database(std::vector<std::string>& arguments) {
  std::optional<std::string> database;
  std::vector<std::string> settings;
  for (auto& argument : arguments) {
    if (argument.find('=') != std::string::npos) {
      settings.push_back(std::move(argument));
    } else if (database) {
      throw usage_failure("plot: unexpected argument: " + argument + " (the database is " + *database +
                          "; parameters are of the form PARAMETER=VALUE)");
    } else {
      database = std::move(argument);
    }
  }
  arguments = std::move(settings);
  return database;
}

ExitCode draw(const Options& options, const Context& context) {
  const auto& figure = require_figure(options.figure);
  auto arguments = options.arguments;
  const auto database = take_database(arguments);
  const bool needs_database = figure.source == plot::Source::results;
  if (needs_database && !database)
    throw usage_failure("plot: figure " + options.figure + " is drawn from a results database: name its file");
  if (!needs_database && database)
    throw usage_failure("plot: figure " + options.figure + " is drawn from parameters alone, not from " + *database);
  plot::Request request{.evidence = nullptr,
                        .settings = split_settings(arguments),
                        .sweep = options.sweep,
                        .jobs = options.jobs,
                        .average_by = options.average_by,
                        .time_steps = options.time_steps};
  if (options.cycles) request.settings.emplace_back("cycles", std::to_string(*options.cycles));
  std::optional<Evidence> evidence;
  if (database) request.evidence = &evidence.emplace(*database);
  const std::string output = options.output.empty() ? options.figure + ".svg" : options.output;
  const auto format = plot::format_of(output);
  plot::draw(figure.make(request, figure), output, format, context.environment.interrupted);
  if (context.format == Format::json) {
    Json json = document("plot");
    json["figure"] = options.figure;
    json["output"] = output;
    print(context.console, json);
  } else {
    context.console.out << output << '\n';
  }
  return exit_ok;
}

}  // namespace

Action declare_plot(CLI::App& app) {
  auto options = std::make_shared<Options>();
  constexpr std::uint64_t most_steps = 100'000;
  app.description(
      "Draws a figure with gnuplot into an SVG or PNG file. Figures of results are drawn from a database, those of a "
      "gait "
      "from parameters. 'lamprey plot list' lists the figures.");
  app.add_option("FIGURE", options->figure, "Number or name of the figure, or 'list'")->required();
  app.add_option("DATABASE|PARAMETER=VALUE", options->arguments,
                 "The results database; parameters of the gait, or values that the jobs must have");
  app.add_option("--output", options->output, "File to write, .svg or .png (default: FIGURE.svg)")->type_name("FILE");
  app.add_option("--sweep", options->sweep, "Draw from this sweep instead of the figure's own")->type_name("SWEEP");
  app.add_option("--cycles", options->cycles, "Draw from jobs of so many cycles: 2000 are those of appendix B")
      ->type_name("N")
      ->check(whole_number(1, 10'000'000));
  app.add_option("--jobs", options->jobs, "Figure fitness: only these jobs, a curve each")
      ->type_name("N,N...")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--average-by", options->average_by, "Figure fitness: a mean curve for each value of this column")
      ->type_name("COLUMN");
  app.add_option("--time-steps", options->time_steps, "Steps of a gait to show (default: what suits the figure)")
      ->type_name("N")
      ->check(whole_number(1, most_steps));
  app.footer(
      "Examples\n  lamprey plot 8-3 results.db\n  lamprey plot 8-7 results.db posture=carry --output carry.png\n"
      "  lamprey plot fitness results.db --sweep quickstart --average-by acceptance\n"
      "  lamprey plot side-view gait=trot");
  return
      [options](const Context& context) { return options->figure == "list" ? list(context) : draw(*options, context); };
}

}  // namespace lamprey::client::commands
