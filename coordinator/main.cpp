#include "coordinator/coordinator.hpp"
#include "messaging/names.hpp"
#include "messaging/program/build_info.hpp"
#include "messaging/program/exit_codes.hpp"
#include "messaging/program/join_options.hpp"
#include "messaging/program/network_report.hpp"
#include "messaging/program/run.hpp"
#include "messaging/program/stall_guard.hpp"
#include "messaging/program/stop.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <spdlog/spdlog.h>
#include <string>

namespace {

using namespace lamprey;
namespace program = messaging::program;

/// Commits and heartbeats are looked after at least this often.
constexpr auto longest_wait = std::chrono::milliseconds{25};

struct Options {
  std::string database;
  std::string bridge_isolation;  ///< where robots are; empty: where this coordinator is
  messaging::JoinOptions join;
  program::LoggingOptions logging;
};

int serve(const Options& options) {
  storage::ResultsStore store(options.database);
  auto signal = std::make_shared<messaging::Signal>();
  const program::StopOnSignal stop(signal);
  const auto participant = messaging::join(options.join);
  const auto bridges = program::join_bridges(options.join, options.bridge_isolation);
  spdlog::info("{}, database {}, epoch {}, {} domain {}, isolation {}", program::build(), options.database,
               store.epoch(), participant->vendor(), options.join.domain, options.join.isolation);
  program::warn_of_open_door(options.join, bridges != nullptr);
  coordinator::Coordinator coordinator(*participant, std::move(store), signal, {}, coordinator::Clock::now(),
                                       bridges.get());
  program::NetworkReport network(*participant, options.join);
  program::StallGuard guard;
  while (!stop.requested()) {
    signal->wait_for(longest_wait);
    guard.alive();
    network.step(program::NetworkReport::Clock::now());
    coordinator.step(coordinator::Clock::now());
  }
  coordinator.finish(coordinator::Clock::now());
  spdlog::info("stopped");
  return program::exit_ok;
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("Splits sweeps into jobs, leases them to workers over DDS, and stores their results in SQLite.");
  app.name("lamprey-coordinator");
  app.set_version_flag("--version", program::build());
  Options options;
  app.add_option("--database", options.database, "Results database; made if it does not exist")
      ->required()
      ->type_name("FILE");
  app.add_option("--bridge-isolation", options.bridge_isolation,
                 "Where robots' bridges are, for the event log, if they are in another isolation")
      ->check([](const std::string& name) {
        return messaging::is_valid_isolation(name) ? "" : "'" + name + "' is not an isolation";
      })
      ->type_name("NAME");
  options.join.introduction = program::introduction("coordinator");
  program::add_join_options(app, options.join);
  program::add_logging_options(app, options.logging);
  return program::run(app, count, arguments, options.logging, [&]() -> int {
    try {
      return serve(options);
    } catch (const storage::StorageError& error) {
      spdlog::error("{}", error.what());
      return program::exit_storage;
    }
  });
}
