// Commands a robot as a worker does, evaluation after evaluation, and tells when it has sent each command and when it
// has got the state that answers it. Waits for the robot, and claims it anew, whenever it is away.
//
//   robot_commander --robot NAME --seconds N [--steps N] [--stops N] [DDS options]
//
// Prints CSV: time_step,sent_ns,answered_ns (CLOCK_MONOTONIC; no answer of a step that was void). With --stops the
// robot is stopped so often in mid-motion, by somebody whom the bridge knows already; then `time_step` of such a line
// is "stop".
#include "messaging/program/exit_codes.hpp"
#include "messaging/program/join_options.hpp"
#include "messaging/program/stop.hpp"
#include "messaging/robot/robot_asker.hpp"
#include "messaging/robot/robot_name.hpp"
#include "worker/robot/robot_connection.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <random>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <stop_token>
#include <string>
#include <thread>

namespace {

using namespace lamprey;
using Clock = std::chrono::steady_clock;

struct Options {
  std::string robot;
  double seconds = 10;
  std::uint32_t steps = 20;
  int stops = 0;
  messaging::JoinOptions join;
};

std::int64_t nanoseconds(Clock::time_point time) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count();
}

/// All servos up and down again between the standing position and 8 units above: slow enough for any slew rate.
messaging::ServoPositions target(std::uint64_t moment) {
  constexpr double standing = 10;
  constexpr double per_step = 0.4;
  constexpr std::uint64_t way = 20;
  const std::uint64_t phase = moment % (2 * way);
  messaging::ServoPositions position{};
  position.fill(standing + per_step * static_cast<double>(phase < way ? phase : 2 * way - phase));
  return position;
}

class Commander {
 public:
  Commander(messaging::Participant& participant, const Options& options)
      : options_(options), connection_(participant, options.robot, std::random_device()() + std::uint64_t{1}) {}

  void run(const std::stop_token& stop) {
    const auto end = Clock::now() + std::chrono::duration<double>(options_.stops == 0 ? options_.seconds : 24 * 3600.0);
    std::puts("time_step,sent_ns,answered_ns");
    while (Clock::now() < end && !stop.stop_requested()) {
      const std::uint64_t token = connection_.token();
      const bool ours = connection_.keep_claim(stop);
      if (connection_.token() != token) evaluation_ = 0;
      if (!ours || (!placed_ && connection_.place(target(moment_), stop))) {
        connection_.wait(std::chrono::milliseconds(20));
        continue;
      }
      placed_ = evaluate(stop);
    }
    connection_.release({});
  }

 private:
  /// Whether no step was void.
  bool evaluate(const std::stop_token& stop) {
    ++evaluation_;
    for (std::uint32_t step = 0; step <= options_.steps; ++step) {
      messaging::ServoCommand command;
      command.evaluation = evaluation_;
      command.time_step = step;
      command.last = step == options_.steps;
      command.position = target(step == 0 ? moment_ : ++moment_);
      const auto sent = Clock::now();
      const auto state = connection_.step(command, stop);
      const auto answered = Clock::now();
      if (stop.stop_requested()) return false;
      const bool done = state.outcome == messaging::StepOutcome::done;
      std::printf("%" PRIu32 ",%" PRId64 ",%s\n", step, nanoseconds(sent),
                  done ? std::to_string(nanoseconds(answered)).c_str() : "");
      if (!done) return false;
    }
    return true;
  }

  const Options& options_;
  worker::RobotConnection connection_;
  std::uint64_t evaluation_ = 0;
  std::uint64_t moment_ = 0;
  bool placed_ = false;
};

/// Stops the robot, and turns it on again, so that the commander can go on; both in a process of their own would have
/// to be found first.
void stop_again_and_again(messaging::Participant& participant, const Options& options, const std::stop_token& stop) {
  using messaging::RobotRequestKind;
  messaging::RobotAsker asker(participant, std::make_shared<messaging::Signal>(),
                              messaging::robot_number(options.robot), std::random_device()() + std::uint64_t{1});
  const auto ask = [&](RobotRequestKind kind) {
    messaging::RobotRequest request;
    request.kind = kind;
    request.confirmed = true;
    request.reason = "a measurement";
    return asker.ask(request, std::chrono::seconds(10), [&] { return stop.stop_requested(); });
  };
  ask(RobotRequestKind::reset);
  for (int i = 0; i < options.stops && !stop.stop_requested(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(500 + 7 * (i % 10)));
    const auto asked = Clock::now();
    const auto reply = ask(RobotRequestKind::stop);
    const auto answered = Clock::now();
    const bool confirmed = reply && reply->granted && reply->reason.empty();
    std::printf("stop,%" PRId64 ",%s\n", nanoseconds(asked),
                confirmed ? std::to_string(nanoseconds(answered)).c_str() : "");
    ask(RobotRequestKind::reset);
    ask(RobotRequestKind::activate);
  }
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("Commands a robot as a worker does, and tells when.");
  Options options;
  app.add_option("--robot", options.robot)->required();
  app.add_option("--seconds", options.seconds)->check(CLI::PositiveNumber);
  app.add_option("--steps", options.steps, "Of an evaluation")->check(CLI::Range(1, 10'000));
  app.add_option("--stops", options.stops, "Instead of --seconds: until it has been stopped so often")
      ->check(CLI::Range(1, 10'000));
  messaging::program::add_join_options(app, options.join);
  try {
    app.parse(count, arguments);
    spdlog::set_default_logger(spdlog::stderr_logger_st("robot_commander"));
    const messaging::program::StopOnSignal stop(std::make_shared<messaging::Signal>());
    const auto participant = messaging::join(options.join);
    Commander commander(*participant, options);
    if (options.stops == 0) {
      commander.run(stop.token());
    } else {
      const std::jthread thread([&](const std::stop_token& enough) { commander.run(enough); });
      stop_again_and_again(*participant, options, stop.token());
    }
    return messaging::program::exit_ok;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? messaging::program::exit_ok : messaging::program::exit_usage;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "robot_commander: %s\n", error.what());
    return messaging::program::exit_failure;
  }
}
