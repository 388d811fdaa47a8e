#include "client/commands/commands.hpp"
#include "client/output/formatting.hpp"
#include "client/sweep_control.hpp"
#include "client/sweep_input.hpp"

#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  ControlOptions control;
  std::string file;
  SweepOverrides overrides;  ///< the name alone
};

ExitCode resume(const Options& options, const Context& context) {
  const auto& sweep = options.control.sweep;
  auto request = control_request(sweep, idl::ControlRequest::RESUME);
  if (!options.file.empty()) {
    *request.mutable_control()->mutable_specification() =
        read_sweep(options.file, options.overrides).file.specification;
  }
  CoordinatorConnection connection(context.environment, options.control.connection);
  const auto reply = connection.ask(request);
  if (reply.has_error() && reply.error().code() == "sweep_changed") {
    throw Failure(exit_usage, "sweep_changed",
                  {options.file + " is not sweep '" + sweep + "' as the database has it, so it is not resumed:"},
                  {reply.error().messages().begin(), reply.error().messages().end()});
  }
  require_success(reply);
  print_control(context, "resume", sweep, reply.control(),
                "Sweep " + sweep + " is " + reply.control().state() + ", " +
                    output::counted(reply.control().jobs(), "job", "jobs") + " pending.");
  return exit_ok;
}

}  // namespace

Action declare_resume(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Lets a paused sweep go on, each job from its newest checkpoint. With a sweep file it does so only if the file "
      "still says the same as the database; else the differences are shown and nothing is done.");
  app.add_option("SWEEP", options->control.sweep, "Name or id")->required();
  app.add_option("FILE", options->file, "The sweep file that it must be");
  app.add_option("--name", options->overrides.name, "The name that the file was submitted under, if not its own")
      ->type_name("NAME");
  add_connection_options(app, options->control.connection);
  return [options](const Context& context) { return resume(*options, context); };
}

}  // namespace lamprey::client::commands
