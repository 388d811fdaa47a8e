#include "client/commands/commands.hpp"
#include "client/json.hpp"
#include "client/option_checks.hpp"
#include "client/sweep_control.hpp"
#include "experiment/sweep_validation.hpp"

#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  ControlOptions control;
  std::string name;
};

ExitCode rename(const Options& options, const Context& context) {
  idl::Request request;
  request.mutable_rename()->set_sweep(options.control.sweep);
  request.mutable_rename()->set_name(options.name);
  steer(options.control, context, request);
  if (context.format == Format::json) {
    Json json = document("rename");
    json["sweep"] = options.control.sweep;
    json["name"] = options.name;
    print(context.console, json);
  } else {
    context.console.out << "Sweep " << options.control.sweep << " is called " << options.name
                        << " now; its id stays, and its file still makes the same sweep.\n";
  }
  return exit_ok;
}

}  // namespace

Action declare_rename(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Gives a sweep another name, on command lines and in results. What it is stays the same: its id, its jobs, its "
      "outcomes.");
  app.add_option("SWEEP", options->control.sweep, "Name or id")->required();
  app.add_option("NAME", options->name, "Its new name")->required()->check([](const std::string& name) {
    return experiment::sweep_name_fault(name).value_or("");
  });
  add_connection_options(app, options->control.connection);
  return [options](const Context& context) { return rename(*options, context); };
}

}  // namespace lamprey::client::commands
