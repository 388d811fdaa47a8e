#include "client/commands/commands.hpp"
#include "client/coordinator_connection.hpp"
#include "client/failure.hpp"
#include "client/json.hpp"
#include "client/option_checks.hpp"
#include "client/output/formatting.hpp"
#include "client/output/table.hpp"
#include "messaging/program/join_options.hpp"
#include "messaging/robot/robot_asker.hpp"
#include "messaging/robot/robot_name.hpp"
#include "messaging/robot/robot_state.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace lamprey::client::commands {

namespace {

using messaging::RobotReply;
using messaging::RobotRequest;
using messaging::RobotRequestKind;
using messaging::RobotStatus;
using output::without_controls;

struct Options {
  std::string action;
  std::string robot;
  std::string reason;
  bool confirm_pose = false;
  std::string driver;  ///< of calibrate, as all up to the file
  std::string port;
  std::string calibration;
  messaging::JoinOptions join;
  double timeout_seconds = 5;
};

struct ActionKind {
  std::string_view name;
  RobotRequestKind kind;
  std::string_view done;  ///< "Robot NAME …"
};
constexpr std::array actions{ActionKind{"stop", RobotRequestKind::stop, "is stopped; its servos are off"},
                             ActionKind{"reset", RobotRequestKind::reset, "may be activated again"},
                             ActionKind{"activate", RobotRequestKind::activate, "is active: its servos are on"},
                             ActionKind{"deactivate", RobotRequestKind::deactivate, "is inactive: its servos are off"}};

std::unique_ptr<messaging::Participant> join(const messaging::JoinOptions& options, const Context& context) {
  try {
    return context.environment.join(options);
  } catch (const std::runtime_error& error) {
    throw Failure(exit_unreachable, "cannot_join", error.what());
  }
}

Clock::duration timeout(const Options& options) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.timeout_seconds));
}

Failure unreachable(const Options& options) {
  return {exit_unreachable, "unreachable",
          "no bridge of robot '" + options.robot + "' answered within " + output::duration(options.timeout_seconds) +
              " (" + options.join.vendor + ", domain " + std::to_string(options.join.domain) + ", isolation " +
              options.join.isolation + "). Is lamprey-bridge running, with the same domain and isolation?"};
}

/// The newest status of each robot that is heard of within the time, or of the one that is asked for as soon as it is.
std::map<std::string, RobotStatus> listen(const Options& options, const Context& context) {
  const auto participant = join(options.join, context);
  const auto signal = std::make_shared<messaging::Signal>();
  const auto reader = participant->reader<RobotStatus>(signal);
  // Statuses of robots that are there come at once, others never: no need to wait for long.
  constexpr std::chrono::milliseconds first_look{1500};
  const auto until = Clock::now() + (options.robot.empty() ? std::min<Clock::duration>(first_look, timeout(options))
                                                           : timeout(options));
  std::map<std::string, RobotStatus> robots;
  while (Clock::now() < until) {
    if (context.environment.interrupted()) throw interrupted_failure();
    for (auto& status : reader->take()) {
      const bool asked_for = options.robot.empty() || status.name == options.robot;
      if (asked_for && status.state != messaging::RobotState::finalized) robots[status.name] = std::move(status);
    }
    if (!options.robot.empty() && !robots.empty()) break;
    signal->wait_for(std::chrono::milliseconds(50));
  }
  if (!options.robot.empty() && robots.empty()) throw unreachable(options);
  return robots;
}

Json json_of(const RobotStatus& status) {
  Json counters = Json::object();
  for (const auto& counter : status.counters) counters[counter.name] = counter.value;
  return {{"robot", status.name},
          {"state", to_text(status.state)},
          {"stopped", status.stopped},
          {"reason", status.reason},
          {"claim", status.holder == 0 ? Json(nullptr) : Json(status.token)},
          {"rate", status.rate},
          {"driver", status.driver},
          {"device", status.device},
          {"scheduling", status.scheduling},
          {"host", status.host},
          {"process", status.process},
          {"build", status.build},
          {"dds", status.dds},
          {"counters", counters}};
}

void print_status(const output::Console& console, const RobotStatus& status) {
  std::vector<std::pair<std::string, std::string>> pairs = {
      {"robot", console.bold(without_controls(status.name))},
      {"state", std::string(to_text(status.state)) + (status.stopped ? ", EMERGENCY STOP" : "")}};
  if (!status.reason.empty()) pairs.emplace_back("reason", without_controls(status.reason));
  pairs.emplace_back("claim", status.holder == 0 ? "nobody's" : "number " + std::to_string(status.token));
  pairs.emplace_back("rate", output::shortest(status.rate) + " steps per second");
  pairs.emplace_back("device", without_controls(status.driver + ": " + status.device));
  pairs.emplace_back("bridge", without_controls(status.host + "/" + std::to_string(status.process) + ", " + status.dds +
                                                ", " + status.scheduling));
  for (const auto& counter : status.counters) {
    if (counter.value > 0) pairs.emplace_back(without_controls(counter.name), output::with_thousands(counter.value));
  }
  output::print_pairs(console, pairs);
}

ExitCode show(const Options& options, const Context& context) {
  const auto robots = listen(options, context);
  if (context.format == Format::json) {
    Json json = document("bridge");
    json["robots"] = Json::array();
    for (const auto& [name, status] : robots) json["robots"].push_back(json_of(status));
    print(context.console, json);
    return exit_ok;
  }
  if (robots.empty()) context.console.out << "No robots: start lamprey-bridge where the servo controller is.\n";
  bool first = true;
  for (const auto& [name, status] : robots) {
    if (!std::exchange(first, false)) context.console.out << '\n';
    print_status(context.console, status);
  }
  return exit_ok;
}

/// Nothing, and a warning, where that vendor can't be had.
std::unique_ptr<messaging::Participant> join_for_emergency(const Options& options, const Context& context) {
  auto join = options.join;
  join.vendor = messaging::emergency_vendor;
  try {
    return context.environment.join(join);
  } catch (const std::runtime_error& error) {
    context.console.err << "lamprey: " << context.console.red("warning:") << " the stop goes out over "
                        << options.join.vendor << " alone: " << error.what() << '\n';
    return nullptr;
  }
}

std::optional<RobotReply> ask(const Options& options, const RobotRequest& request, const Context& context) {
  // Long enough for an answer on a loaded machine.
  const auto head_start = std::min<Clock::duration>(std::chrono::milliseconds(200), timeout(options) / 2);
  const auto until = Clock::now() + timeout(options);
  const auto signal = std::make_shared<messaging::Signal>();
  std::vector<std::unique_ptr<messaging::Participant>> participants;
  std::vector<messaging::RobotAsker> askers;
  const auto ask_over = [&](std::unique_ptr<messaging::Participant> participant, Clock::duration time) {
    askers.emplace_back(*participant, signal, messaging::robot_number(options.robot), random_id());
    participants.push_back(std::move(participant));
    return messaging::RobotAsker::ask(askers, request, time, context.environment.interrupted);
  };
  // An emergency stop doesn't wait until a slow vendor has found the bridge.
  const bool by_server = !options.join.discovery_servers.empty();  // where nobody of that vendor is met
  if (request.kind == RobotRequestKind::stop && options.join.vendor != messaging::emergency_vendor && !by_server) {
    auto participant = join_for_emergency(options, context);
    if (participant) {
      if (auto reply = ask_over(std::move(participant), head_start)) return reply;
    }
  }
  return ask_over(join(options.join, context), until - Clock::now());
}

ExitCode act(const Options& options, const ActionKind& action, const Context& context) {
  RobotRequest request;
  request.kind = action.kind;
  request.confirmed = options.confirm_pose;
  request.reason = options.reason;
  const auto begin = Clock::now();
  const auto reply = ask(options, request, context);
  if (!reply) throw context.environment.interrupted() ? interrupted_failure() : unreachable(options);
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  if (!reply->granted) {
    throw Failure(exit_failure, "refused", "robot '" + options.robot + "': " + without_controls(reply->reason));
  }
  if (context.format == Format::json) {
    Json json = document("bridge");
    json["robot"] = options.robot;
    json["action"] = action.name;
    json["state"] = to_text(reply->state);
    json["stopped"] = reply->stopped;
    json["reason"] = reply->reason;
    json["seconds"] = seconds;
    print(context.console, json);
    return exit_ok;
  }
  context.console.out << "Robot " << options.robot << ' '
                      << (reply->reason.empty() ? std::string(action.done) : without_controls(reply->reason)) << " ("
                      << output::duration(seconds) << ").\n";
  return exit_ok;
}

/// Becomes the program that talks with whoever stands at the robot; needs no bridge, and none may hold the line.
[[noreturn]] void calibrate(const Options& options, const Context& context) {
  if (options.driver.empty() || options.port.empty() || options.calibration.empty()) {
    throw usage_failure("lamprey bridge calibrate needs --driver, --port and --calibration");
  }
  const std::string program = (context.environment.program_folder / "lamprey-calibrate").string();
  ::execl(program.c_str(), program.c_str(), "--driver", options.driver.c_str(), "--port", options.port.c_str(),
          "--calibration", options.calibration.c_str(), nullptr);
  throw Failure(exit_failure, "cannot_start", program + " can't be started: " + std::strerror(errno));
}

ExitCode bridge(const Options& options, const Context& context) {
  if (options.action == "status") return show(options, context);
  if (options.action == "calibrate") calibrate(options, context);
  if (options.robot.empty()) throw usage_failure("which robot? lamprey bridge " + options.action + " NAME");
  const auto action = std::ranges::find(actions, options.action, &ActionKind::name);
  return act(options, *action, context);
}

}  // namespace

Action declare_bridge(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Asks a robot's bridge directly; no coordinator is needed. An emergency stop takes the torque off all servos and "
      "stays, also over a restart of the bridge, until it is reset.");
  app.add_option("ACTION", options->action, "status, stop, reset, activate, deactivate or calibrate")
      ->required()
      ->check(one_of({"status", "stop", "reset", "activate", "deactivate", "calibrate"}));
  app.add_option("NAME", options->robot, "The robot; for status: all that are there by default")->check(robot_name());
  app.add_option("--reason", options->reason, "Of an emergency stop: kept, and told to whoever asks")
      ->type_name("TEXT");
  app.add_flag("--confirm-pose", options->confirm_pose,
               "Of activate: the robot stands in its standing pose (for controllers that can't tell)");
  app.add_option("--driver", options->driver, "Of calibrate: ssc32 or dynamixel")->type_name("DRIVER");
  app.add_option("--port", options->port, "Of calibrate: the servo controller's serial line")->type_name("DEVICE");
  app.add_option("--calibration", options->calibration, "Of calibrate: the file to write, or to mend")
      ->type_name("FILE");
  add_timeout_option(app, options->timeout_seconds);
  messaging::program::add_join_options(app, options->join);
  app.footer("Example\n  lamprey bridge status\n  lamprey bridge stop bench --reason 'it smells'");
  return [options](const Context& context) { return bridge(*options, context); };
}

}  // namespace lamprey::client::commands
