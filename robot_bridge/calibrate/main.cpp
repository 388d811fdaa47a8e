#include "experiment/problem.hpp"
#include "messaging/program/build_info.hpp"
#include "messaging/program/exit_codes.hpp"
#include "robot_bridge/calibrate/file.hpp"
#include "robot_bridge/calibrate/session.hpp"
#include "robot_bridge/drivers/registry.hpp"

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

namespace {

using namespace lamprey;
namespace program = messaging::program;
using robot_bridge::Calibration;
using robot_bridge::DeviceFamily;

std::atomic<bool> interrupted_by_signal{false};
static_assert(std::atomic<bool>::is_always_lock_free);

struct Options {
  std::string driver;
  std::string port;
  std::string calibration;
  std::int32_t baud = 0;
};

/// What is there already, or a first draft.
Calibration begin_with(const Options& options) {
  const auto family = options.driver == "ssc32" ? DeviceFamily::ssc32 : DeviceFamily::dynamixel;
  if (!std::filesystem::exists(options.calibration)) {
    constexpr std::int32_t ssc32_baud = 115200;
    constexpr std::int32_t dynamixel_baud = 1'000'000;
    const std::int32_t usual = family == DeviceFamily::ssc32 ? ssc32_baud : dynamixel_baud;
    return robot_bridge::calibrate::first_draft(family, options.baud != 0 ? options.baud : usual);
  }
  Calibration calibration = robot_bridge::read_calibration(options.calibration);
  if (calibration.family != family) {
    throw CLI::ValidationError("--calibration", options.calibration + " is of driver '" +
                                                    std::string(robot_bridge::to_text(calibration.family)) +
                                                    "', not '" + options.driver + "'");
  }
  if (options.baud != 0) calibration.baud = options.baud;
  return calibration;
}

/// Ctrl-C ends the read of a line too: the handler is not one that starts it again.
void end_on_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted_by_signal = true; };
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

int calibrate(const Options& options) {
  const Calibration begin = begin_with(options);
  const auto driver = robot_bridge::make_driver(robot_bridge::calibrate::whole_range(begin), options.port);
  end_on_signals();
  driver->connect();
  robot_bridge::calibrate::Session session(*driver, begin, std::cin, std::cout,
                                           [] { return interrupted_by_signal.load(); });
  const auto ending = session.run();
  if (ending == robot_bridge::calibrate::Ending::save) {
    robot_bridge::calibrate::write_calibration(session.calibration(), options.calibration);
    std::cout << options.calibration << " is written.\n";
    return program::exit_ok;
  }
  std::cout << "Nothing is written.\n";
  return interrupted_by_signal ? program::exit_interrupted : program::exit_ok;
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app(
      "Moves a robot's servos one at a time while a person says where each leg stands and where its range ends, and "
      "writes the calibration file. No bridge may be using the line.");
  app.name("lamprey-calibrate");
  app.set_version_flag("--version", program::build());
  Options options;
  app.add_option("--driver", options.driver, "ssc32 or dynamixel")
      ->required()
      ->check(CLI::IsMember({"ssc32", "dynamixel"}))
      ->type_name("DRIVER");
  app.add_option("--port", options.port, "The servo controller's serial line")->required()->type_name("DEVICE");
  app.add_option("--calibration", options.calibration, "The file to write; where it exists, to begin with")
      ->required()
      ->type_name("FILE");
  app.add_option("--baud", options.baud, "Of the line; by default the file's, or 115200 (ssc32), 1000000 (dynamixel)")
      ->type_name("BAUD");
  try {
    app.parse(count, arguments);
    return calibrate(options);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? program::exit_ok : program::exit_usage;
  } catch (const experiment::InvalidInput& error) {
    std::cerr << "lamprey-calibrate: " << error.what() << '\n';
    return program::exit_usage;
  } catch (const std::exception& error) {
    std::cerr << "lamprey-calibrate: " << error.what() << '\n';
    return program::exit_failure;
  }
}
