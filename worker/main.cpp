#include "experiment/execution_validation.hpp"
#include "messaging/process_identity.hpp"
#include "messaging/program/build_info.hpp"
#include "messaging/program/exit_codes.hpp"
#include "messaging/program/join_options.hpp"
#include "messaging/program/network_report.hpp"
#include "messaging/program/run.hpp"
#include "messaging/program/stall_guard.hpp"
#include "messaging/program/stop.hpp"
#include "messaging/robot/robot_name.hpp"
#include "worker/host.hpp"
#include "worker/robot/robot_executor.hpp"
#include "worker/worker.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <memory>
#include <spdlog/spdlog.h>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

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
  int nice = 19;
  std::vector<std::string> labels;
  std::string bridge;            ///< the name of a robot; empty: none
  std::string bridge_isolation;  ///< where its bridge is; empty: where this worker is
  messaging::JoinOptions join;
  program::LoggingOptions logging;
};

int serve(const Options& options) {
  auto signal = std::make_shared<messaging::Signal>();
  const program::StopOnSignal stop(signal);
  const auto participant = messaging::join(options.join);
  worker::WorkerOptions identity;
  identity.incarnation = messaging::random_id();
  const auto with_bridge =
      options.bridge.empty() ? nullptr : program::join_bridges(options.join, options.bridge_isolation);
  const auto executor =
      options.bridge.empty()
          ? worker::make_thread_pool(options.threads, signal, worker::default_checkpoint_interval, options.nice)
          : worker::make_robot_executor(with_bridge ? *with_bridge : *participant, signal,
                                        {.robot = options.bridge, .asker = identity.incarnation});
  identity.host = messaging::host_name();
  identity.process = static_cast<std::uint32_t>(::getpid());
  identity.build = program::build();
  identity.flags = program::flags();
  identity.processor = worker::processor_name();
  identity.instruction_set = worker::instruction_set();
  identity.labels = options.labels;
  spdlog::info("{}, worker {:016x}, {} threads, {} domain {}, isolation {}; waiting for a coordinator",
               program::build(), identity.incarnation, executor->threads(), participant->vendor(), options.join.domain,
               options.join.isolation);
  program::warn_of_open_door(options.join, with_bridge != nullptr);
  worker::Worker worker(*participant, *executor, signal, identity, worker::Clock::now());
  program::NetworkReport network(*participant, options.join);
  program::StallGuard guard;
  while (!stop.requested() && !worker.drained()) {
    signal->wait_for(longest_wait);
    guard.alive();
    network.step(program::NetworkReport::Clock::now());
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
  app.add_option("--nice", options.nice,
                 "Niceness of what computes, so that heartbeats and others on this host go first")
      ->check(CLI::Range(0, 19))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--label", options.labels, "Of this worker, for sweeps that need it; may be given several times")
      ->allow_extra_args(false)
      ->check([](const std::string& label) { return experiment::label_fault(label, "label").value_or(""); })
      ->type_name("LABEL");
  app.add_option("--bridge", options.bridge,
                 "Jobs on the robot of that name, once its bridge grants the claim; no others")
      ->check([](const std::string& name) {
        return messaging::is_valid_robot(name) ? "" : "'" + name + "': 1 to 64 of A-Z a-z 0-9 _ . -";
      })
      ->type_name("NAME");
  app.add_option("--bridge-isolation", options.bridge_isolation,
                 "The isolation that the bridge is in (default: this worker's); it may be on another machine")
      ->type_name("NAME");
  options.join.introduction = program::introduction("worker");
  options.join.one_of_many = true;
  program::add_join_options(app, options.join);
  program::add_logging_options(app, options.logging);
  return program::run(app, count, arguments, options.logging, [&] { return serve(options); });
}
