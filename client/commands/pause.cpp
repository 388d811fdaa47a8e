#include "client/commands/commands.hpp"
#include "client/output/formatting.hpp"
#include "client/sweep_control.hpp"

#include <memory>

namespace lamprey::client::commands {

namespace {

ExitCode pause(const ControlOptions& options, const Context& context) {
  const auto reply = steer(options, context, control_request(options.sweep, idl::ControlRequest::PAUSE));
  print_control(context, "pause", options.sweep, reply,
                "Sweep " + options.sweep + " is " + reply.state() + ", " +
                    output::counted(reply.jobs(), "job", "jobs") +
                    " pending. Running jobs keep what they have done; lamprey resume " + options.sweep + " goes on.");
  return exit_ok;
}

}  // namespace

Action declare_pause(CLI::App& app) {
  auto options = std::make_shared<ControlOptions>();
  app.description(
      "Pauses a sweep: nothing more of it is leased, and running jobs stop at a checkpoint from which they go on "
      "later. "
      "It stays paused over a restart of the coordinator.");
  add_control_options(app, *options);
  return [options](const Context& context) { return pause(*options, context); };
}

}  // namespace lamprey::client::commands
