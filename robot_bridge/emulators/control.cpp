#include "robot_bridge/emulators/control.hpp"

#include "robot_bridge/emulators/foot_switch.hpp"

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

namespace lamprey::robot_bridge::emulators {
namespace {

using Words = std::vector<std::string>;

struct Request {
  const Words& words;
  Line& line;
  const ProgramActions& actions;
  Time now;

  const std::string& argument(std::size_t number) const { return words[number]; }
};

/// A command: its name, its arguments as they are written, what it does.
struct Row {
  std::string_view name;
  std::string_view arguments;
  std::size_t count;
  std::string (*act)(const Request&);
};

constexpr int longest_delay_milliseconds = 60'000;

bool on_or_off(const std::string& word) {
  if (word == "on") return true;
  if (word == "off") return false;
  throw std::invalid_argument("expected on or off, not '" + word + "'");
}

double real(const std::string& word, double lowest, double highest, const std::string& range) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !(value >= lowest && value <= highest)) {
    throw std::invalid_argument("'" + word + "' is not in " + range);
  }
  return value;
}

unsigned servo(const std::string& word) {
  const auto number = parse_number(word);
  if (!number) throw std::invalid_argument("no servo '" + word + "'");
  return static_cast<unsigned>(*number);
}

std::string silence(const Request& request) {
  request.line.faults().silence = on_or_off(request.argument(1));
  return "ok";
}
std::string partial(const Request& request) {
  request.line.faults().partial = on_or_off(request.argument(1));
  return "ok";
}
std::string noise(const Request& request) {
  const std::string& rate = request.argument(1);
  request.line.faults().noise = rate == "off" ? 0 : real(rate, 0, 1, "0..1, or off");
  return "ok";
}
std::string slow(const Request& request) {
  const std::string& delay = request.argument(1);
  const double milliseconds =
      delay == "off" ? 0 : real(delay, 0, longest_delay_milliseconds, "0..60000 (milliseconds), or off");
  request.line.faults().slow =
      std::chrono::duration_cast<Time>(std::chrono::duration<double, std::milli>(milliseconds));
  return "ok";
}
std::string unplug(const Request& request) {
  request.actions.unplug();
  return "ok";
}
std::string replug(const Request& request) {
  request.actions.replug();
  return "ok";
}
std::string overload(const Request& request) {
  const bool on = on_or_off(request.argument(2));
  request.line.controller().overload(servo(request.argument(1)), on, request.now);
  return "ok";
}
std::string place(const Request& request) {
  constexpr double any = 1e9;
  const double position = real(request.argument(2), -any, any, "the range of positions");
  request.line.controller().place(servo(request.argument(1)), position, request.now);
  return "ok";
}
std::string reset(const Request& request) {
  request.line.faults().clear();
  request.line.cut();
  request.line.controller().reset(request.now);
  return "ok";
}
std::string state(const Request& request) {
  return request.line.controller().state(request.now).dump();
}
std::string report(const Request& request) {
  return request.actions.report();
}

constexpr std::array rows{Row{"silence", "on|off", 1, silence},
                          Row{"noise", "RATE|off", 1, noise},
                          Row{"partial", "on|off", 1, partial},
                          Row{"slow", "MILLISECONDS|off", 1, slow},
                          Row{"unplug", "", 0, unplug},
                          Row{"replug", "", 0, replug},
                          Row{"overload", "SERVO on|off", 2, overload},
                          Row{"place", "SERVO POSITION", 2, place},
                          Row{"reset", "", 0, reset},
                          Row{"state", "", 0, state},
                          Row{"report", "", 0, report}};

Words split(std::string_view line) {
  Words words;
  std::string word;
  for (const char c : line) {
    const bool space = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!space) word += c;
    if (space && !word.empty()) words.push_back(std::exchange(word, {}));
  }
  if (!word.empty()) words.push_back(word);
  return words;
}

std::string unknown(const std::string& command) {
  std::string known;
  for (const Row& row : rows) known += (known.empty() ? "" : ", ") + std::string(row.name);
  return "error unknown command '" + command + "'; commands are " + known;
}

}  // namespace

std::string control(std::string_view line, Line& emulated, const ProgramActions& actions, Time now) {
  const Words words = split(line);
  const std::string command = words.empty() ? "" : words.front();
  for (const Row& row : rows) {
    if (row.name != command) continue;
    if (words.size() != row.count + 1) {
      return "error usage: " + command + (row.arguments.empty() ? "" : " ") + std::string(row.arguments);
    }
    try {
      return row.act({words, emulated, actions, now});
    } catch (const std::invalid_argument& error) {
      return "error " + command + ": " + error.what();
    } catch (const std::runtime_error& error) {
      return "error " + command + ": " + error.what();
    }
  }
  return unknown(command);
}

}  // namespace lamprey::robot_bridge::emulators
