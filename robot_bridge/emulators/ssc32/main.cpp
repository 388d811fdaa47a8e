#include "messaging/program/exit_codes.hpp"
#include "robot_bridge/emulators/serve.hpp"
#include "robot_bridge/emulators/ssc32/ssc32.hpp"
#include "science/robots/quadruped.hpp"

#include <CLI/CLI.hpp>

namespace {

using namespace lamprey;
using namespace lamprey::robot_bridge::emulators;

constexpr unsigned preset_baud = 115200;

/// Channels are servos by their numbers, inputs are feet by theirs. A unit is 50 µs, and standing is 1000 µs.
void add_quadruped(ssc32::Settings& settings) {
  constexpr double standing = 1000;
  settings.position = standing;
  for (unsigned servo = 0; servo < science::robots::servos; ++servo) settings.servos.insert(servo);
  for (unsigned leg = 0; leg < science::robots::legs; ++leg) {
    settings.feet.push_back({leg, static_cast<unsigned>(science::robots::vertical_servo(leg)), true, standing});
  }
}

int run(int count, char** arguments) {
  CLI::App app(
      "A Lynxmotion SSC-32U servo controller on a pseudo-terminal, with servos that move and feet that touch.");
  app.name("lamprey-ssc32-emulator");
  app.set_version_flag("--version", LAMPREY_VERSION);
  ProgramOptions options;
  options.baud = preset_baud;
  ssc32::Settings settings;
  std::optional<double> position;
  add_program_options(app, options);
  app.add_option("--position", position, "Of all servos before the first command, in µs (default: 1500, or standing)")
      ->check(CLI::Range(ssc32::shortest_pulse, ssc32::longest_pulse))
      ->type_name("PULSE");
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? messaging::program::exit_ok : messaging::program::exit_usage;
  }
  if (options.quadruped) add_quadruped(settings);
  const FootSwitchForm form{
      true, ssc32::digital_inputs, 0, ssc32::channels - 1, ssc32::shortest_pulse, ssc32::longest_pulse};
  for (const std::string& foot : options.feet) settings.feet.push_back(parse_foot_switch(foot, form));
  for (const FootSwitch& foot : settings.feet) settings.servos.insert(foot.servo);
  settings.position = position.value_or(settings.position);
  settings.speed = servo_speed(options.speed, settings.speed);
  return serve(options, "SSC-32",
               [&](Recorder& recorder, Time now) { return std::make_unique<ssc32::Ssc32>(settings, recorder, now); });
}

}  // namespace

int main(int count, char** arguments) {
  return run_program("lamprey-ssc32-emulator", [&] { return run(count, arguments); });
}
