#include "client/commands/commands.hpp"
#include "client/output/formatting.hpp"
#include "client/sweep_control.hpp"

#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  ControlOptions control;
  bool cancelled = false;
};

ExitCode retry(const Options& options, const Context& context) {
  const auto& sweep = options.control.sweep;
  auto request = control_request(sweep, idl::ControlRequest::RETRY);
  request.mutable_control()->set_cancelled_too(options.cancelled);
  const auto reply = steer(options.control, context, request);
  const std::string what = options.cancelled ? "failed, quarantined or cancelled" : "failed or quarantined";
  print_control(context, "retry", sweep, reply,
                reply.jobs() == 0 ? "Sweep " + sweep + ": no job is " + what + "; nothing to try again."
                                  : "Sweep " + sweep + ": " + output::counted(reply.jobs(), "job is", "jobs are") +
                                        " pending again.");
  return exit_ok;
}

}  // namespace

Action declare_retry(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Tries the failed and quarantined jobs of a sweep again. Why they ended as they did is kept in the database, as "
      "attempts; outcomes that exist stay.");
  add_control_options(app, options->control);
  app.add_flag("--cancelled", options->cancelled, "Cancelled jobs too");
  return [options](const Context& context) { return retry(*options, context); };
}

}  // namespace lamprey::client::commands
