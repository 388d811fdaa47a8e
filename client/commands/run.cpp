#include "client/commands/commands.hpp"
#include "client/coordinator_connection.hpp"
#include "client/failure.hpp"
#include "client/json.hpp"
#include "client/option_checks.hpp"
#include "client/output/formatting.hpp"
#include "client/output/progress.hpp"
#include "client/output/table.hpp"
#include "client/processes/fleet.hpp"
#include "client/stored_sweep.hpp"
#include "client/sweep_control.hpp"
#include "client/sweep_input.hpp"
#include "client/sweep_summary.hpp"
#include "client/sweep_watch.hpp"
#include "experiment/parameters.hpp"
#include "experiment/sweep.hpp"
#include "messaging/program/join_options.hpp"
#include "messaging/program/logging.hpp"
#include "messaging/vendor_library.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string file;
  std::string database;
  std::uint32_t workers = std::max(std::thread::hardware_concurrency(), 1U);
  std::uint32_t threads = 1;
  std::vector<std::string> worker_vendors;
  std::string bridge;
  std::string bridge_isolation;  ///< empty: that of other programs here
  bool quiet = false;
  SweepOverrides overrides;
  ConnectionOptions connection{.join = {}, .timeout_seconds = 30, .file_would_do = false};
  messaging::program::LoggingOptions logging{.level = "warn", .format = "text"};
};

/// How a run went.
struct Result {
  messaging::SweepProgress sweep;
  bool existed = false;      ///< the database had the sweep already
  bool had_ended = false;    ///< … and nothing was left to do
  double seconds = 0;        ///< from the start of the command to the end of the sweep
  std::uint64_t reused = 0;  ///< outcomes that the database had already
  std::string reason = {};   ///< why the sweep was stopped, where that was not a person's wish
};

std::string random_isolation() {
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(random_id()));
  return std::string("run-") + digits.data();
}

/// What the coordinator that is about to start answers.
idl::Reply ask(CoordinatorConnection& connection, processes::Fleet& fleet, const idl::Request& request) {
  auto& client = connection.client();
  const auto until = Clock::now() + connection.timeout();
  client.begin(request, Clock::now());
  while (true) {
    const auto now = Clock::now();
    if (connection.interrupted()) throw interrupted_failure();
    fleet.step(now);
    if (auto reply = client.poll(now)) return std::move(*reply);
    if (now >= until) throw connection.unreachable();
    constexpr std::chrono::milliseconds look_interval{25};
    connection.signal()->wait_for(look_interval);
  }
}

/// Submits; whether the database had the sweep already. Whoever runs a paused sweep wants it to go on.
bool submit(CoordinatorConnection& connection, processes::Fleet& fleet, const SweepInput& sweep, bool is_paused) {
  const auto reply = ask(connection, fleet, submit_request(sweep));
  require_accepted(reply, sweep);
  if (is_paused) {
    const auto resume = control_request(experiment::to_hex(sweep.id), idl::ControlRequest::RESUME);
    require_success(ask(connection, fleet, resume));
  }
  return reply.submit().existed();
}

Result run_processes(const Options& options, const SweepInput& sweep, bool is_paused, const Context& context) {
  const auto begin = Clock::now();
  output::ProgressDisplay display(context.console, options.quiet);
  display.show(sweep.name() + "  starting a coordinator and " + output::counted(options.workers, "worker", "workers"),
               begin);
  ConnectionOptions connection_options = options.connection;
  const std::string& bridge_isolation =
      options.bridge_isolation.empty() ? options.connection.join.isolation : options.bridge_isolation;
  connection_options.join.isolation = random_isolation();
  connection_options.join.loopback_only = true;
  processes::Fleet fleet({.program_folder = context.environment.program_folder,
                          .database = options.database,
                          .workers = options.workers,
                          .threads = options.threads,
                          .join = connection_options.join,
                          .worker_vendors = options.worker_vendors,
                          .log_level = options.logging.level,
                          .bridge = options.bridge,
                          .bridge_isolation = bridge_isolation},
                         [&](const std::string& line) { display.say(line); });
  CoordinatorConnection connection(context.environment, connection_options);
  Result result;
  result.existed = submit(connection, fleet, sweep, is_paused);
  result.sweep = wait_for_end(connection, sweep.id, display, [&](Clock::time_point now) { fleet.step(now); });
  result.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  if (const auto reply = ask(connection, fleet, status_request(sweep)); reply.status().sweeps_size() > 0) {
    result.reused = reply.status().sweeps(0).reused();
    result.reason = reply.status().sweeps(0).reason();
  }
  fleet.stop();
  return result;
}

/// What Ctrl-C has left, as the database has it.
Failure interrupted_run(const Options& options, const SweepInput& sweep) {
  const auto stored = stored_sweep(options.database, sweep);
  if (!stored) return interrupted_failure("interrupted before the sweep was stored");
  const std::uint64_t ended = stored->done + stored->failed + stored->quarantined + stored->cancelled;
  return interrupted_failure("interrupted: " + output::with_thousands(ended) + " of " +
                             output::counted(stored->jobs, "job", "jobs") + " have ended and are stored in " +
                             options.database + "; run the same command again to go on");
}

Result run_or_go_on(const Options& options, const SweepInput& sweep, const Context& context) {
  const auto stored = stored_sweep(options.database, sweep);
  if (stored && has_ended(stored->state)) {
    return {.sweep = *stored, .existed = true, .had_ended = true};
  }
  try {
    return run_processes(options, sweep, stored && stored->state == "paused", context);
  } catch (const Failure& failure) {
    if (failure.exit_code() != exit_interrupted) throw;
    throw interrupted_run(options, sweep);
  }
}

Json json_of(const Options& options, const Result& result) {
  Json json = document("run");
  add_sweep(json, result.sweep);
  json["existed"] = result.existed;
  json["had_ended"] = result.had_ended;
  json["reused"] = result.had_ended ? Json(nullptr) : Json(result.reused);
  json["reason"] = result.reason;
  json["seconds"] = result.seconds;
  json["database"] = options.database;
  json["workers"] = result.had_ended ? 0 : options.workers;
  json["threads"] = result.had_ended ? 0 : options.threads;
  json["dds"] = options.connection.join.vendor;
  return json;
}

/// In single quotes if a shell would read it otherwise.
std::string shell_word(const std::string& text) {
  const bool plain = !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-./:=+@%,").find(c) != std::string_view::npos;
  });
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// Whether the sweep's jobs differ in the parameter.
bool varies(const experiment::SweepGrid& sweep, std::string_view parameter) {
  std::set<experiment::Value> values;
  for (const auto& grid : sweep.grids()) {
    for (const auto& axis : grid.axes) {
      if (axis.parameter == experiment::parameter_index(parameter))
        values.insert(axis.values.begin(), axis.values.end());
    }
  }
  return values.size() > 1;
}

/// A query to begin with: means for each combination of the sweep's choices, three of them at most.
std::string first_query(const SweepInput& sweep) {
  constexpr std::size_t most_columns = 3;
  const experiment::SweepGrid grid(sweep.file.specification);
  std::string columns;
  std::string numbers;
  std::size_t count = 0;
  for (const auto& parameter : experiment::registry()) {
    if (count == most_columns || parameter.kind != experiment::ParameterKind::choice) continue;
    if (!varies(grid, parameter.name)) continue;
    columns += std::string(parameter.name) + ", ";
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(++count);
  }
  return "SELECT " + columns + "count(*), avg(evolved_total) FROM result WHERE sweep = '" + sweep.name() + "'" +
         (numbers.empty() ? "" : " GROUP BY " + numbers);
}

void print_summary(const output::Console& console, const Options& options, const SweepInput& input,
                   const Result& result) {
  const auto& sweep = result.sweep;
  std::vector<std::pair<std::string, std::string>> pairs = {
      {"sweep", console.bold(sweep.name)},
      {"state", sweep.state + (result.reason.empty() ? "" : ": " + output::without_controls(result.reason)) +
                    (result.had_ended ? " (it had ended before; nothing was left to do)" : "")},
      {"result", counts_text(sweep)}};
  if (sweep.divergences > 0)
    pairs.emplace_back("divergent", output::with_thousands(sweep.divergences) + " (see the table divergence)");
  if (result.reused > 0) pairs.emplace_back("reused", reused_text(result.reused));
  if (!result.had_ended) pairs.emplace_back("time", output::duration(result.seconds));
  pairs.emplace_back("database", options.database);
  output::print_pairs(console, pairs);
  const std::string database = shell_word(options.database);
  console.out << "\nNext\n  lamprey results " << sweep.name << " --database " << database << '\n';
  if (exit_code_of(sweep) == exit_ok) {
    console.out << "  sqlite3 -box " << database << " \"" << first_query(input) << "\"\n";
  } else {
    console.out << "  sqlite3 -box " << database << " \"SELECT job, state, reason FROM job WHERE state <> 'done'\"\n";
  }
}

/// Jobs on a robot need one, and one robot is moved by one worker.
void check_bridge(Options& options, const SweepInput& sweep) {
  const bool asks_for_robot = experiment::SweepGrid(sweep.file.specification).asks_for_robot();
  if (asks_for_robot && options.bridge.empty()) {
    throw usage_failure("sweep " + sweep.name() +
                        " has jobs on a robot (robot: bridge): name its bridge, --bridge NAME");
  }
  if (!asks_for_robot && !options.bridge.empty()) {
    throw usage_failure("sweep " + sweep.name() + " has no jobs on a robot (robot: bridge), so --bridge is of no use");
  }
  if (asks_for_robot) options.workers = 1;
}

ExitCode run(Options options, const Context& context) {
  const SweepInput sweep = read_sweep(options.file, options.overrides);
  check_bridge(options, sweep);
  const Result result = run_or_go_on(options, sweep, context);
  if (context.format == Format::json) {
    print(context.console, json_of(options, result));
  } else {
    print_summary(context.console, options, sweep, result);
  }
  return exit_code_of(result.sweep);
}

}  // namespace

Action declare_run(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Runs a whole sweep on this machine: starts a coordinator and workers, shows how it goes, ends them with the "
      "sweep. "
      "Everything is in the database at any moment: after an interruption the same command goes on, and after the end "
      "it "
      "only says so. Several runs side by side don't meet.");
  app.add_option("FILE", options->file, "Sweep file (YAML)")->required();
  app.add_option("--database", options->database, "Results database; made if it does not exist")
      ->required()
      ->type_name("FILE");
  app.add_option("--workers", options->workers, "Worker processes (default: one per core)")
      ->type_name("N")
      ->check(whole_number(1, 64));
  app.add_option("--threads", options->threads, "Threads of each worker")
      ->type_name("N")
      ->check(whole_number(1, 1024))
      ->capture_default_str();
  app.add_flag("-q,--quiet", options->quiet, "No progress");
  add_sweep_overrides(app, options->overrides);
  const auto vendors = std::make_shared<const std::vector<std::string>>(messaging::available_vendors());
  app.add_option("--worker-dds", options->worker_vendors,
                 "DDS implementation of the workers, taken in turn if given several times (default: as --dds)")
      ->type_name("VENDOR")
      ->allow_extra_args(false)
      ->check([vendors](const std::string& vendor) {
        return one_of({vendors->begin(), vendors->end()})(vendor);
      });
  app.add_option("--bridge", options->bridge, "Robot for the sweep's jobs with `robot: bridge`, by its bridge's name")
      ->type_name("NAME")
      ->check(robot_name());
  app.add_option("--bridge-isolation", options->bridge_isolation,
                 "The isolation that the bridge is in (default: the configuration file's, else " +
                     messaging::JoinOptions{}.isolation + ")")
      ->type_name("NAME")
      ->envname("LAMPREY_ISOLATION");
  add_connection_options(app, options->connection);
  // A run is among itself, on this machine.
  for (const char* name : {"--loopback-only", "--isolation", "--peer", "--interface", "--discovery-server"}) {
    app.remove_option(app.get_option(name));
  }
  messaging::program::add_logging_options(app, options->logging);
  app.remove_option(app.get_option("--log-format"));
  app.footer("Example\n  lamprey run sweeps/quickstart.yaml --database results.db");
  return [options](const Context& context) { return run(*options, context); };
}

}  // namespace lamprey::client::commands
