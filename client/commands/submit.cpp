#include "client/commands/commands.hpp"
#include "client/coordinator_connection.hpp"
#include "client/failure.hpp"
#include "client/json.hpp"
#include "client/output/formatting.hpp"
#include "client/output/table.hpp"
#include "client/sweep_input.hpp"
#include "client/sweep_summary.hpp"
#include "client/sweep_watch.hpp"

#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string file;
  bool wait = false;
  bool quiet = false;
  ConnectionOptions connection;
};

messaging::SweepProgress wait(CoordinatorConnection& connection, const SweepInput& sweep, const Options& options,
                              const output::Console& console) {
  output::ProgressDisplay display(console, options.quiet);
  try {
    return wait_for_end(connection, sweep.id, display);
  } catch (const Failure& failure) {
    if (failure.exit_code() != exit_interrupted) throw;
    throw interrupted_failure("no longer waiting; sweep " + sweep.name() +
                              " goes on. Submit it again with --wait to follow it, or see lamprey status " +
                              sweep.name());
  }
}

ExitCode submit(const Options& options, const Context& context) {
  const SweepInput sweep = read_sweep(options.file);
  CoordinatorConnection connection(context.environment, options.connection);
  const auto reply = connection.ask(submit_request(sweep));
  require_accepted(reply, sweep);
  const bool existed = reply.submit().existed();
  const auto& console = context.console;
  Json json = document("submit");
  json["sweep"] = sweep.name();
  json["id"] = reply.submit().id();
  json["jobs"] = reply.submit().jobs();
  json["existed"] = existed;
  if (context.format != Format::json) {
    output::print_pairs(console, {{"sweep", console.bold(sweep.name())},
                                  {"id", reply.submit().id()},
                                  {"jobs", output::with_thousands(reply.submit().jobs())}});
    if (existed) console.out << "It had been submitted before; nothing changes.\n";
    console.out.flush();
  }
  ExitCode code = exit_ok;
  if (options.wait) {
    const auto end = wait(connection, sweep, options, console);
    add_sweep(json, end);
    if (context.format != Format::json)
      console.out << "Sweep " << end.name << " is " << end.state << ", " << counts_text(end) << ".\n";
    code = exit_code_of(end);
  }
  if (context.format == Format::json) print(console, json);
  return code;
}

}  // namespace

Action declare_submit(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Gives a sweep to the coordinator, whose workers run it. Submitting the same sweep again changes nothing: a "
      "sweep "
      "is what its file says, and it is known by that.");
  app.add_option("FILE", options->file, "Sweep file (YAML)")->required();
  app.add_flag("--wait", options->wait, "Show progress and end with the sweep");
  app.add_flag("-q,--quiet", options->quiet, "No progress");
  add_connection_options(app, options->connection);
  return [options](const Context& context) { return submit(*options, context); };
}

}  // namespace lamprey::client::commands
