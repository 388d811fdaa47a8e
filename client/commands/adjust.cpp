#include "client/commands/commands.hpp"
#include "client/failure.hpp"
#include "client/json.hpp"
#include "client/option_checks.hpp"
#include "client/output/formatting.hpp"
#include "client/sweep_control.hpp"
#include "experiment/execution_validation.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamprey::client::commands {

namespace {

struct Options {
  ControlOptions control;
  std::optional<std::int32_t> priority;
  std::optional<std::uint32_t> max_concurrent;
};

std::string limit_text(std::uint32_t max_concurrent) {
  if (max_concurrent == 0) return "any number of jobs at once";
  return "at most " + output::counted(max_concurrent, "job", "jobs") + " at once";
}

ExitCode adjust(const Options& options, const Context& context) {
  if (!options.priority && !options.max_concurrent) {
    throw usage_failure("adjust: nothing to change; give --priority, --max-concurrent or both");
  }
  idl::Request request;
  auto& wish = *request.mutable_adjust();
  wish.set_sweep(options.control.sweep);
  if (options.priority) wish.set_priority(*options.priority);
  if (options.max_concurrent) wish.set_max_concurrent(*options.max_concurrent);
  steer(options.control, context, request);
  if (context.format == Format::json) {
    Json json = document("adjust");
    json["sweep"] = options.control.sweep;
    if (options.priority) json["priority"] = *options.priority;
    if (options.max_concurrent) {
      json["max_concurrent"] = *options.max_concurrent == 0 ? Json(nullptr) : Json(*options.max_concurrent);
    }
    print(context.console, json);
    return exit_ok;
  }
  std::vector<std::string> changes;
  if (options.priority) changes.push_back("priority " + std::to_string(*options.priority));
  if (options.max_concurrent) changes.push_back(limit_text(*options.max_concurrent));
  context.console.out << "Sweep " << options.control.sweep << ": " << output::joined(changes, ", ") << ".\n";
  return exit_ok;
}

}  // namespace

Action declare_adjust(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Changes how a sweep is run, while it runs or before it does: among which sweeps it comes first, and how many of "
      "its jobs are with workers at once. Changes no outcome.");
  add_control_options(app, options->control);
  app.add_option("--priority", options->priority, "Sweeps of higher priority are served first")
      ->type_name("N")
      ->check(whole_number_between(experiment::minimum_priority, experiment::maximum_priority));
  app.add_option("--max-concurrent", options->max_concurrent, "At most this many of its jobs at once; 0: any number")
      ->type_name("N")
      ->check(whole_number(0, experiment::maximum_concurrent_jobs));
  return [options](const Context& context) { return adjust(*options, context); };
}

}  // namespace lamprey::client::commands
