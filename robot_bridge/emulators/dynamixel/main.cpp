#include "messaging/program/exit_codes.hpp"
#include "robot_bridge/emulators/dynamixel/bus.hpp"
#include "robot_bridge/emulators/serve.hpp"
#include "science/robots/quadruped.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>

namespace {

using namespace lamprey;
using namespace lamprey::robot_bridge::emulators;

constexpr unsigned preset_baud = 1'000'000;
constexpr int highest_position = 4095;

/// Servo n has the id n + 1, a foot's bit is its number. A unit is 40 ticks, and standing is 2048.
void add_quadruped(dynamixel::Settings& settings) {
  constexpr double standing = 2048;
  constexpr dynamixel::Board board{200, 10};
  settings.servo.position = standing;
  settings.board = board;
  for (unsigned servo = 0; servo < science::robots::servos; ++servo) {
    settings.servos.push_back(static_cast<std::uint8_t>(servo + 1));
  }
  for (unsigned leg = 0; leg < science::robots::legs; ++leg) {
    settings.feet.push_back({leg, static_cast<unsigned>(science::robots::vertical_servo(leg) + 1), true, standing});
  }
}

dynamixel::Board parse_board(const std::string& text) {
  using dynamixel::ContactBoard;
  const auto colon = text.find(':');
  const auto id = parse_number(std::string_view(text).substr(0, colon));
  const auto address =
      colon == std::string::npos ? std::nullopt : parse_number(std::string_view(text).substr(colon + 1));
  if (!id || !address || *id > dynamixel::highest_id || *address < ContactBoard::lowest_address ||
      *address > ContactBoard::highest_address) {
    throw std::invalid_argument("--contact-board: '" + text + "' is not ID:ADDRESS, 0..252 and 10..255");
  }
  return {static_cast<std::uint8_t>(*id), static_cast<std::uint16_t>(*address)};
}

void check(const dynamixel::Settings& settings) {
  auto ids = settings.servos;
  std::ranges::sort(ids);
  if (ids.empty()) throw std::invalid_argument("--servos: at least one id is needed, or --quadruped");
  if (const auto twice = std::ranges::adjacent_find(ids); twice != ids.end()) {
    throw std::invalid_argument("--servos: id " + std::to_string(*twice) + " is there twice");
  }
  const auto is_servo = [&](unsigned id) { return std::ranges::find(ids, id) != ids.end(); };
  if (settings.board && is_servo(settings.board->id)) {
    throw std::invalid_argument("--contact-board: id " + std::to_string(settings.board->id) + " is a servo's");
  }
  for (const FootSwitch& foot : settings.feet) {
    if (!is_servo(foot.servo)) throw std::invalid_argument("--foot: no servo has the id " + std::to_string(foot.servo));
  }
}

int run(int count, char** arguments) {
  CLI::App app("DYNAMIXEL X servos on one bus, on a pseudo-terminal, with a board that tells which feet touch.");
  app.name("lamprey-dynamixel-emulator");
  app.set_version_flag("--version", LAMPREY_VERSION);
  ProgramOptions options;
  options.baud = preset_baud;
  dynamixel::Settings settings;
  std::optional<double> position;
  std::vector<unsigned> ids;
  std::string board;
  add_program_options(app, options);
  app.add_option("--servos", ids, "Ids of the servos, with commas between them")
      ->delimiter(',')
      ->check(CLI::Range(0U, unsigned{dynamixel::highest_id}))
      ->type_name("ID,…");
  app.add_option("--contact-board", board, "A device of its own with an octet of contacts")->type_name("ID:ADDRESS");
  app.add_option("--position", position, "Of all servos at power-up, in ticks (default: 2048)")
      ->check(CLI::Range(0, highest_position))
      ->type_name("TICKS");
  app.add_option("--firmware", settings.servo.firmware, "Version of the servos; time-based profiles begin with 42")
      ->check(CLI::Range(1, 255))
      ->capture_default_str()
      ->type_name("N");
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? messaging::program::exit_ok : messaging::program::exit_usage;
  }
  if (options.quadruped) add_quadruped(settings);
  for (const unsigned id : ids) settings.servos.push_back(static_cast<std::uint8_t>(id));
  if (!board.empty()) settings.board = parse_board(board);
  const FootSwitchForm form{false, 8, 0, dynamixel::highest_id, 0, highest_position};
  for (const std::string& foot : options.feet) settings.feet.push_back(parse_foot_switch(foot, form));
  check(settings);
  const auto baud = dynamixel::baud_register(options.baud);
  if (!baud) throw std::invalid_argument("--baud: " + std::to_string(options.baud) + " is no speed of these servos");
  settings.servo.baud_register = *baud;
  settings.servo.position = position.value_or(settings.servo.position);
  settings.servo.speed = servo_speed(options.speed, settings.servo.speed);
  return serve(options, "DYNAMIXEL",
               [&](Recorder& recorder, Time now) { return std::make_unique<dynamixel::Bus>(settings, recorder, now); });
}

}  // namespace

int main(int count, char** arguments) {
  return run_program("lamprey-dynamixel-emulator", [&] { return run(count, arguments); });
}
