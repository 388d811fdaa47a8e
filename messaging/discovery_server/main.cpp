#include "messaging/discovery/server.hpp"
#include "messaging/discovery/server_address.hpp"
#include "messaging/program/build_info.hpp"
#include "messaging/program/exit_codes.hpp"
#include "messaging/program/join_options.hpp"
#include "messaging/program/run.hpp"
#include "messaging/program/stop.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <spdlog/spdlog.h>

namespace {

using namespace lamprey;
namespace program = messaging::program;
using messaging::discovery::ServerAddress;

/// Longer than clients remember a server that was killed here a moment ago.
constexpr std::chrono::milliseconds silence = messaging::discovery::server_lease + std::chrono::milliseconds(500);

/// A signal to stop wakes the program at once.
constexpr std::chrono::hours until_then{1};

struct Options {
  std::optional<std::uint16_t> port;
  messaging::JoinOptions join;
  program::LoggingOptions logging;
};

int serve(const Options& options) {
  auto signal = std::make_shared<messaging::Signal>();
  const program::StopOnSignal stop(signal);
  const auto port = options.port.value_or(messaging::discovery::server_port_of(options.join.domain));
  program::warn_of_open_door(options.join);
  signal->wait_for(silence);
  if (stop.requested()) return program::exit_ok;
  const auto server = messaging::discovery::serve(options.join, port);
  spdlog::info("{}, programs of Fast DDS find each other at UDP port {} (identity {})", program::build(), port,
               ServerAddress{{}, port}.identity());
  while (!stop.requested()) signal->wait_for(until_then);
  spdlog::info("stopped");
  return program::exit_ok;
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app(
      "Lets programs on Fast DDS find each other where there is no multicast and nobody's address is known but this "
      "one's: they name it with --discovery-server. What they have to say to each other doesn't go through it.");
  app.name("lamprey-discovery-server");
  app.set_version_flag("--version", program::build());
  Options options;
  app.add_option("--port", options.port,
                 "UDP port, by which servers are told apart (default: " + std::to_string(ServerAddress::first_port) +
                     " + domain)")
      ->check(CLI::Range(ServerAddress::first_port, ServerAddress::last_port))
      ->type_name("PORT");
  options.join.introduction = program::introduction(messaging::discovery::server_role);
  program::add_join_options(app, options.join);
  for (const auto* const name : {"--dds", "--isolation", "--peer", "--discovery-server", "--loopback-only"}) {
    app.remove_option(app.get_option(name));
  }
  program::add_logging_options(app, options.logging);
  return program::run(app, count, arguments, options.logging, [&] {
    if (options.join.loopback_only) {
      throw CLI::ValidationError(options.join.configuration_file +
                                 ": loopback_only: programs of one machine find each other without a discovery server");
    }
    // A site's settings for those who ask it have no meaning here.
    options.join.vendor = "fastdds";
    options.join.isolation.clear();
    options.join.peers.clear();
    options.join.discovery_servers.clear();
    return serve(options);
  });
}
