#include "experiment/problem.hpp"
#include "messaging/process_identity.hpp"
#include "messaging/program/build_info.hpp"
#include "messaging/program/exit_codes.hpp"
#include "messaging/program/join_options.hpp"
#include "messaging/program/network_report.hpp"
#include "messaging/program/run.hpp"
#include "messaging/program/stall_guard.hpp"
#include "messaging/program/stop.hpp"
#include "messaging/robot/robot_asker.hpp"
#include "messaging/robot/robot_name.hpp"
#include "messaging/ros2/node.hpp"
#include "messaging/tuning.hpp"
#include "robot_bridge/bridge.hpp"
#include "robot_bridge/drivers/registry.hpp"
#include "robot_bridge/dry_run_driver.hpp"
#include "robot_bridge/recording/step_recorder.hpp"
#include "robot_bridge/ros2/face.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <memory>
#include <optional>
#include <spdlog/spdlog.h>
#include <string>
#include <thread>
#include <unistd.h>

namespace {

using namespace lamprey;
namespace program = messaging::program;
using robot_bridge::Calibration;
using robot_bridge::Clock;

/// Requests and commands wake the loop; a deadline is met this late at most.
constexpr auto longest_wait = std::chrono::milliseconds{10};
constexpr std::chrono::seconds longest_stall{10};
constexpr auto goodbye_time = std::chrono::milliseconds{100};

struct Options {
  std::string robot;
  std::string driver;
  std::string port;
  std::string calibration;
  std::string timing;
  std::string record;
  std::string state_folder = robot_bridge::default_state_folder().string();
  double rate = 50;
  int grace_milliseconds = 200;
  int off_after_milliseconds = 10'000;
  bool activate = false;
  bool confirm_pose = false;
  bool dry_run = false;
  bool ros2 = false;
  std::optional<std::uint32_t> ros2_domain;
  messaging::JoinOptions join;
  program::LoggingOptions logging;
};

/// The calibration, which has to be of the driver that is asked for.
Calibration calibration_of(const Options& options) {
  if (options.calibration.empty()) {
    if (options.driver != "mock") {
      throw CLI::ValidationError("--calibration", "driver '" + options.driver + "' needs a calibration file");
    }
    return robot_bridge::mock_calibration();
  }
  auto calibration = robot_bridge::read_calibration(options.calibration);
  if (robot_bridge::to_text(calibration.family) != options.driver) {
    throw CLI::ValidationError("--calibration", options.calibration + " is of driver '" +
                                                    std::string(robot_bridge::to_text(calibration.family)) +
                                                    "', not '" + options.driver + "'");
  }
  return calibration;
}

void log_counters(const robot_bridge::Bridge& bridge) {
  std::string text;
  for (const auto& counter : bridge.counters()) {
    if (counter.value > 0) text += (text.empty() ? "" : ", ") + counter.name + " " + std::to_string(counter.value);
  }
  spdlog::info("stopped; {}", text.empty() ? "nothing happened" : text);
}

/// Opened before anything moves, so that it can be written when all is over.
std::ofstream open_timing(const std::string& path) {
  std::ofstream file;
  if (path.empty()) return file;
  file.open(path);
  if (!file) throw CLI::ValidationError("--timing", "'" + path + "' can't be written");
  return file;
}

/// Nothing where ROS 2 isn't asked for.
std::unique_ptr<messaging::ros2::Node> join_ros2(const Options& options) {
  if (!options.ros2) return nullptr;
  auto join = options.join;
  join.domain = options.ros2_domain.value_or(options.join.domain);
  auto node = messaging::ros2::join(join);
  spdlog::info("ROS 2 sees the robot in domain {}", join.domain);
  return node;
}

/// Nothing where the bridge is on that vendor anyway, or where a discovery server, which that vendor can't ask, keeps
/// all others away.
std::unique_ptr<messaging::Participant> join_for_emergencies(const messaging::JoinOptions& own) {
  if (own.vendor == messaging::emergency_vendor || !own.discovery_servers.empty()) return nullptr;
  auto join = own;
  join.vendor = messaging::emergency_vendor;
  try {
    return messaging::join(join);
  } catch (const messaging::JoinError& error) {
    spdlog::warn("an emergency stop from a program that has just started may take seconds: {}", error.what());
    return nullptr;
  }
}

int serve(const Options& options) {
  const auto calibration = calibration_of(options);
  auto driver = robot_bridge::make_driver(calibration, options.port);
  if (options.rate > driver->highest_rate()) {
    throw CLI::ValidationError("--rate", std::to_string(options.rate) + " steps per second are more than the " +
                                             std::to_string(driver->highest_rate()) +
                                             " that a move and a read of this device take at " +
                                             std::to_string(calibration.baud) + " baud");
  }
  if (options.dry_run) driver = robot_bridge::make_dry_run_driver(std::move(driver));

  std::ofstream timing = open_timing(options.timing);
  auto signal = std::make_shared<messaging::Signal>();
  const program::StopOnSignal stop(signal);
  std::optional<robot_bridge::recording::StepRecorder> recorder;
  if (!options.record.empty()) recorder.emplace(options.record, calibration);
  const auto record = [&](const messaging::ServoState& state) {
    if (recorder) recorder->add(state, std::chrono::system_clock::now());
  };
  robot_bridge::StateFile file(options.state_folder, options.robot);
  const auto participant = messaging::join(options.join);
  const auto emergency = join_for_emergencies(options.join);
  const auto node = join_ros2(options);
  spdlog::info("{}, robot {}, driver {}{}, {} steps per second, {} domain {}, isolation {}", program::build(),
               options.robot, options.driver, options.dry_run ? " (dry run)" : "", options.rate, participant->vendor(),
               options.join.domain, options.join.isolation);
  program::warn_of_open_door(options.join);
  robot_bridge::ControlLoop control(
      std::move(driver), calibration,
      {.rate = options.rate, .off_after = std::chrono::milliseconds(options.off_after_milliseconds)}, signal);
  if (options.activate && !file.state().stopped) control.activate(options.confirm_pose);
  robot_bridge::Bridge bridge(*participant, signal, control, file,
                              {.robot = options.robot,
                               .driver = options.driver,
                               .rate = options.rate,
                               .grace = std::chrono::milliseconds(options.grace_milliseconds),
                               .emergency = emergency.get(),
                               .incarnation = messaging::random_id(),
                               .host = messaging::host_name(),
                               .process = static_cast<std::uint32_t>(::getpid()),
                               .build = program::build(),
                               .on_state = record},
                              Clock::now());
  std::optional<robot_bridge::ros2::Face> face;
  if (node != nullptr) face.emplace(*node, signal, bridge, control, calibration, options.robot);
  program::NetworkReport network(*participant, options.join);
  // A call into DDS that never returns would leave the robot deaf to its emergency stop.
  program::StallGuard guard(longest_stall, [&control] {
    spdlog::critical("the bridge has stood still for {} s; its servos are turned off, and it ends",
                     longest_stall.count());
    control.stop();
    std::this_thread::sleep_for(std::chrono::seconds(1));
    std::abort();
  });
  while (!stop.requested()) {
    signal->wait_for(longest_wait);
    guard.alive();
    bridge.step(Clock::now());
    network.step(Clock::now());
    if (face) face->step(Clock::now(), std::chrono::system_clock::now());
  }
  bridge.finish();
  if (face) face->finish(std::chrono::system_clock::now());
  log_counters(bridge);
  if (!options.timing.empty() && !(timing << robot_bridge::to_csv(control.timings()) << std::flush)) {
    spdlog::error("'{}' can't be written", options.timing);
  }
  std::this_thread::sleep_for(goodbye_time);
  return program::exit_ok;
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("--robot", options.robot, "Its name, by which workers and clients find it")
      ->required()
      ->check([](const std::string& name) {
        return messaging::is_valid_robot(name) ? "" : "'" + name + "': 1 to 64 of A-Z a-z 0-9 _ . -";
      })
      ->type_name("NAME");
  app.add_option("--driver", options.driver, "mock (the simulated quadruped), ssc32 or dynamixel")
      ->required()
      ->check(CLI::IsMember({"mock", "ssc32", "dynamixel"}))
      ->type_name("DRIVER");
  app.add_option("--port", options.port, "The servo controller's serial line, such as /dev/ttyUSB0")
      ->type_name("DEVICE");
  app.add_option("--calibration", options.calibration, "Calibration file (docs/formats/calibration.md)")
      ->type_name("FILE");
  app.add_option("--rate", options.rate, "Time steps per second")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str()
      ->type_name("HZ");
  app.add_option("--grace", options.grace_milliseconds,
                 "A command may come so late after the state before it; then its evaluation is void")
      ->check(CLI::Range(1, 60'000))
      ->capture_default_str()
      ->type_name("MS");
  app.add_option("--off-after", options.off_after_milliseconds, "Servos that nobody needs are turned off after so long")
      ->check(CLI::Range(100, 3'600'000))
      ->capture_default_str()
      ->type_name("MS");
  app.add_option("--state", options.state_folder, "Folder of what the robot must not forget: claims, emergency stop")
      ->capture_default_str()
      ->type_name("FOLDER");
  app.add_option("--timing", options.timing, "A CSV file with latencies and jitter by time step, written at the end")
      ->type_name("FILE");
  app.add_flag("--activate", options.activate, "Turn the servos on at the start");
  app.add_flag("--confirm-pose", options.confirm_pose,
               "With --activate: the robot stands in its standing pose (for devices that can't tell)");
  app.add_option("--record", options.record, "An MCAP file with each time step, for Foxglove or PlotJuggler")
      ->type_name("FILE");
  auto* const ros2 =
      app.add_flag("--ros2", options.ros2,
                   "Let ROS 2's tools see the robot, and move it while no job has it (docs/guides/robot.md)");
  app.add_option("--ros2-domain", options.ros2_domain, "Domain of ROS 2, where it isn't --domain")
      ->check(CLI::Range(std::uint32_t{0}, messaging::highest_domain))
      ->needs(ros2)
      ->type_name("NUMBER");
  app.add_flag("--dry-run", options.dry_run, "Connect and read, but move nothing: commands go through all limits only");
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("Lets workers move a robot through its servo controller, within its limits.");
  app.name("lamprey-bridge");
  app.set_version_flag("--version", program::build());
  Options options;
  add_options(app, options);
  options.join.introduction = program::introduction("bridge");
  program::add_join_options(app, options.join);
  program::add_logging_options(app, options.logging);
  return program::run(app, count, arguments, options.logging, [&]() -> int {
    if (options.driver != "mock" && options.port.empty()) {
      throw CLI::ValidationError("--port", "driver '" + options.driver + "' needs a serial line");
    }
    try {
      return serve(options);
    } catch (const experiment::InvalidInput& error) {
      spdlog::error("{}", error.what());
      return program::exit_usage;
    }
  });
}
