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
#include <utility>
#include <vector>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string file;
  bool wait = false;
  bool quiet = false;
  SweepOverrides overrides;
  ConnectionOptions connection;
};

/// How it stands beside its counts: outcomes reused, why it was stopped.
idl::SweepStatus status_of(CoordinatorConnection& connection, const SweepInput& sweep) {
  const auto reply = connection.ask_for_success(status_request(sweep));
  return reply.status().sweeps_size() == 0 ? idl::SweepStatus() : reply.status().sweeps(0);
}

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

void print_end(const output::Console& console, const messaging::SweepProgress& end, const idl::SweepStatus& status,
               bool reuse_is_news) {
  console.out << "Sweep " << end.name << " is " << end.state;
  if (!status.reason().empty()) console.out << " (" << output::without_controls(status.reason()) << ")";
  console.out << ", " << counts_text(end) << ".\n";
  if (reuse_is_news && status.reused() > 0) console.out << "Reused " << reused_text(status.reused()) << ".\n";
}

ExitCode submit(const Options& options, const Context& context) {
  const SweepInput sweep = read_sweep(options.file, options.overrides);
  CoordinatorConnection connection(context.environment, options.connection);
  const auto reply = connection.ask(submit_request(sweep));
  require_accepted(reply, sweep);
  const bool existed = reply.submit().existed();
  auto status = status_of(connection, sweep);
  const auto& console = context.console;
  Json json = document("submit");
  json["sweep"] = sweep.name();
  json["id"] = reply.submit().id();
  json["jobs"] = reply.submit().jobs();
  json["existed"] = existed;
  if (context.format != Format::json) {
    std::vector<std::pair<std::string, std::string>> pairs = {{"sweep", console.bold(sweep.name())},
                                                              {"id", reply.submit().id()},
                                                              {"jobs", output::with_thousands(reply.submit().jobs())}};
    if (status.reused() > 0) pairs.emplace_back("reused", reused_text(status.reused()));
    output::print_pairs(console, pairs);
    if (existed) console.out << "It had been submitted before; nothing changes.\n";
    console.out.flush();
  }
  ExitCode code = exit_ok;
  if (options.wait) {
    const auto end = wait(connection, sweep, options, console);
    const bool told = status.reused() > 0;
    status = status_of(connection, sweep);
    add_sweep(json, end);
    json["reason"] = status.reason();
    if (context.format != Format::json) print_end(console, end, status, !told);
    code = exit_code_of(end);
  }
  json["reused"] = status.reused();
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
  add_sweep_overrides(app, options->overrides);
  add_connection_options(app, options->connection);
  return [options](const Context& context) { return submit(*options, context); };
}

}  // namespace lamprey::client::commands
