#pragma once

#include "robot_bridge/emulators/line.hpp"
#include "robot_bridge/emulators/recorder.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lamprey::robot_bridge::emulators {

/// What both emulators are told.
struct ProgramOptions {
  std::string link;
  unsigned baud;
  std::string control;
  std::string report;
  std::string log;
  std::uint64_t seed = 1;
  std::vector<std::string> feet;
  bool quadruped = false;
  std::string speed;  ///< of servos, in units per second, or "instant"; empty for the default
};

/// Adds --link, --baud, --control, --report, --log, --seed, --foot, --quadruped, --speed and --configuration, a file
/// with any of the options as NAME = VALUE lines. Parsing fills `options`, which must outlive the app.
void add_program_options(CLI::App& app, ProgramOptions& options);

/// `speed` as a number, infinity for "instant"; `preset` if it is empty. Throws std::invalid_argument.
double servo_speed(const std::string& speed, double preset);

using MakeController = std::function<std::unique_ptr<Controller>(Recorder&, Time)>;

/// Serves until SIGTERM or SIGINT, and returns the program's exit code. `device` is how the program presents itself:
/// "SSC-32". Throws std::invalid_argument for options that can't be followed, std::system_error if the system refuses.
int serve(const ProgramOptions& options, const std::string& device, const MakeController& make);

/// What main() does: `run` parses and serves; errors are told on standard error and become exit codes.
int run_program(const std::string& name, const std::function<int()>& run);

}  // namespace lamprey::robot_bridge::emulators
