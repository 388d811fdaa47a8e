#include "robot_bridge/emulators/foot_switch.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace lamprey::robot_bridge::emulators {
namespace {

std::string input_name(const FootSwitchForm& form, unsigned input) {
  return form.letters ? std::string(1, static_cast<char>('A' + input)) : std::to_string(input);
}

std::string range(int lowest, int highest) {
  return std::to_string(lowest) + ".." + std::to_string(highest);
}

[[noreturn]] void refuse(std::string_view text, const std::string& what) {
  throw std::invalid_argument("foot '" + std::string(text) + "': " + what);
}

std::optional<unsigned> parse_input(std::string_view name, const FootSwitchForm& form) {
  for (unsigned input = 0; input < form.inputs; ++input) {
    if (name == input_name(form, input)) return input;
  }
  return std::nullopt;
}

}  // namespace

std::optional<int> parse_number(std::string_view digits) {
  constexpr std::size_t most_digits = 9;
  int value = 0;
  if (digits.empty() || digits.size() > most_digits || digits.front() == '-') return std::nullopt;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

FootSwitch parse_foot_switch(std::string_view text, const FootSwitchForm& form) {
  const auto equals = text.find('=');
  const auto side = std::min(text.find("<=", equals == std::string_view::npos ? equals : equals + 1),
                             text.find(">=", equals == std::string_view::npos ? equals : equals + 1));
  if (equals == std::string_view::npos || side == std::string_view::npos) {
    refuse(text, "expected INPUT=SERVO<=THRESHOLD or INPUT=SERVO>=THRESHOLD, such as '" + input_name(form, 0) + "=" +
                     std::to_string(form.lowest_servo) + "<=" + std::to_string(form.lowest) + "'");
  }
  const auto input = parse_input(text.substr(0, equals), form);
  if (!input) {
    refuse(text, "input '" + std::string(text.substr(0, equals)) + "' is not in " + input_name(form, 0) + ".." +
                     input_name(form, form.inputs - 1));
  }
  const auto servo = parse_number(text.substr(equals + 1, side - equals - 1));
  if (!servo || *servo < static_cast<int>(form.lowest_servo) || *servo > static_cast<int>(form.highest_servo)) {
    refuse(text, "servo '" + std::string(text.substr(equals + 1, side - equals - 1)) + "' is not in " +
                     range(static_cast<int>(form.lowest_servo), static_cast<int>(form.highest_servo)));
  }
  const auto threshold = parse_number(text.substr(side + 2));
  if (!threshold || *threshold < form.lowest || *threshold > form.highest) {
    refuse(text,
           "threshold '" + std::string(text.substr(side + 2)) + "' is not in " + range(form.lowest, form.highest));
  }
  return {*input, static_cast<unsigned>(*servo), text[side] == '<', static_cast<double>(*threshold)};
}

}  // namespace lamprey::robot_bridge::emulators
