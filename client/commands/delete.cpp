#include "client/commands/commands.hpp"
#include "client/failure.hpp"
#include "client/output/formatting.hpp"
#include "client/sweep_control.hpp"
#include "client/sweep_summary.hpp"
#include "client/sweep_watch.hpp"

#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  ControlOptions control;
  bool yes = false;
};

/// Says what would go.
Failure unconfirmed(const Options& options, const Context& context) {
  const auto& sweep = options.control.sweep;
  CoordinatorConnection connection(context.environment, options.control.connection);
  idl::Request request;
  request.mutable_status()->set_sweep(sweep);
  const auto reply = connection.ask_for_success(request);
  if (reply.status().sweeps_size() == 0) {
    return {exit_failure, "malformed", "the coordinator has not said what sweep " + sweep + " is"};
  }
  const auto& status = reply.status().sweeps(0);
  std::string message = "deleting sweep '" + status.name() + "' would take its outcomes and traces out of " +
                        reply.status().database() + " for ever (" + counts_text(progress_of(status, 0)) + "). ";
  message +=
      has_ended(status.state())
          ? "If that is meant: lamprey delete " + sweep + " --yes. Out of sight is enough? lamprey archive " + sweep
          : "It is " + status.state() + ", and must be cancelled before it can be deleted: lamprey cancel " + sweep;
  return {exit_usage, "not_confirmed", message};
}

ExitCode remove(const Options& options, const Context& context) {
  if (!options.yes) throw unconfirmed(options, context);
  const auto& sweep = options.control.sweep;
  const auto reply = steer(options.control, context, control_request(sweep, idl::ControlRequest::DELETE));
  print_control(context, "delete", sweep, reply,
                "Sweep " + sweep + ": " + output::counted(reply.jobs(), "job", "jobs") +
                    (reply.state() == "deleted" ? " deleted." : " being deleted; this may take a while."));
  return exit_ok;
}

}  // namespace

Action declare_delete(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Deletes a sweep that has ended, with its outcomes and traces, from the database. What the coordinator has noted "
      "about it in its events stays. Without --yes it only says what would go.");
  add_control_options(app, options->control);
  app.add_flag("--yes", options->yes, "Really do it");
  return [options](const Context& context) { return remove(*options, context); };
}

}  // namespace lamprey::client::commands
