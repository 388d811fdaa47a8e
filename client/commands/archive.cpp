#include "client/commands/commands.hpp"
#include "client/sweep_control.hpp"

#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  ControlOptions control;
  bool undo = false;
};

ExitCode archive(const Options& options, const Context& context) {
  const auto& sweep = options.control.sweep;
  const auto action = options.undo ? idl::ControlRequest::UNARCHIVE : idl::ControlRequest::ARCHIVE;
  const auto reply = steer(options.control, context, control_request(sweep, action));
  print_control(context, "archive", sweep, reply,
                "Sweep " + sweep +
                    (options.undo ? " is in lamprey status again."
                                  : " is archived; lamprey status --all shows it, and its results stay."));
  return exit_ok;
}

}  // namespace

Action declare_archive(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Puts a sweep that has ended out of sight: lamprey status leaves it out unless it is asked for. Nothing is "
      "lost.");
  add_control_options(app, options->control);
  app.add_flag("--undo", options->undo, "Show it again");
  return [options](const Context& context) { return archive(*options, context); };
}

}  // namespace lamprey::client::commands
