#include "messaging/program/build_info.hpp"
#include "messaging/program/exit_codes.hpp"
#include "messaging/program/join_options.hpp"
#include "messaging/program/logging.hpp"
#include "messaging/program/stop.hpp"
#include "worker/worker.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <exception>
#include <memory>
#include <spdlog/spdlog.h>
#include <string>
#include <sys/random.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace {

using namespace lamprey;
namespace program = messaging::program;

constexpr auto longest_wait = std::chrono::milliseconds{25};

/// A leaving worker waits so long for the answers to its last results; then whoever leases the jobs next computes them.
constexpr auto patience_at_the_end = std::chrono::milliseconds{1000};

/// DDS gets so long to carry the goodbye.
constexpr auto goodbye_time = std::chrono::milliseconds{100};

struct Options {
  std::uint32_t threads = std::max(std::thread::hardware_concurrency(), 1U);
  messaging::JoinOptions join;
  program::LoggingOptions logging;
};

std::uint64_t random_incarnation() {
  std::uint64_t value = 0;
  while (value == 0) {
    if (::getrandom(&value, sizeof value, 0) != static_cast<ssize_t>(sizeof value)) {
      throw std::system_error(errno, std::generic_category(), "getrandom");
    }
  }
  return value;
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

int serve(const Options& options) {
  auto signal = std::make_shared<messaging::Signal>();
  const program::StopOnSignal stop(signal);
  const auto participant = messaging::join(options.join);
  const auto executor = worker::make_thread_pool(options.threads, signal);

  worker::WorkerOptions identity;
  identity.incarnation = random_incarnation();
  identity.host = host_name();
  identity.process = static_cast<std::uint32_t>(::getpid());
  identity.build = program::build();
  spdlog::info("{}, worker {:016x}, {} threads, {} domain {}, isolation {}; waiting for a coordinator",
               program::build(), identity.incarnation, options.threads, participant->vendor(), options.join.domain,
               options.join.isolation);
  worker::Worker worker(*participant, *executor, signal, identity, worker::Clock::now());
  while (!stop.requested()) {
    signal->wait_for(longest_wait);
    worker.step(worker::Clock::now());
  }

  worker.begin_leaving(worker::Clock::now());
  const auto until = worker::Clock::now() + patience_at_the_end;
  while (!worker.settled() && worker::Clock::now() < until) {
    worker.step(worker::Clock::now());
    signal->wait_for(longest_wait);
  }
  worker.goodbye(worker::Clock::now());
  std::this_thread::sleep_for(goodbye_time);
  spdlog::info("stopped after {} jobs, {} results without an answer", worker.jobs_done(), worker.results_held());
  return program::exit_ok;
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("Computes jobs that a coordinator leases to it over DDS. Start as many as you like, on any machine.");
  app.name("lamprey-worker");
  app.set_version_flag("--version", program::build());
  Options options;
  app.add_option("--threads", options.threads, "Jobs computed at once (default: one per core)")
      ->check(CLI::Range(1U, 1024U))
      ->type_name("N");
  program::add_join_options(app, options.join);
  program::add_logging_options(app, options.logging);
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? program::exit_ok : program::exit_usage;
  }
  try {
    program::start_logging(options.logging, "lamprey-worker");
    return serve(options);
  } catch (const messaging::JoinError& error) {
    spdlog::error("{}", error.what());
    return program::exit_unreachable;
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return program::exit_failure;
  }
}
