#include "robot_bridge/emulators/ssc32/command.hpp"

#include "robot_bridge/emulators/foot_switch.hpp"

#include <algorithm>
#include <cctype>

namespace lamprey::robot_bridge::emulators::ssc32 {
namespace {

constexpr int highest_number = 65535;
constexpr std::size_t most_reads = 8;

struct Refusal {
  std::string reason;
};

/// Reads a line from left to right; what does not fit ends it with a Refusal.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}
  bool done() const { return text_.empty(); }
  bool take(std::string_view word) {
    if (!text_.starts_with(word)) return false;
    text_.remove_prefix(word.size());
    return true;
  }
  int number(const char* what, int lowest, int highest) {
    const auto end = std::ranges::find_if(text_, [](unsigned char c) { return std::isdigit(c) == 0; });
    const auto digits = text_.substr(0, static_cast<std::size_t>(end - text_.begin()));
    const auto value = parse_number(digits);
    if (!value || *value < lowest || *value > highest) throw Refusal{what};
    text_.remove_prefix(digits.size());
    return *value;
  }
  unsigned channel() { return static_cast<unsigned>(number("channel", 0, channels - 1)); }
  unsigned letter(unsigned letters) {
    if (done() || text_.front() < 'A' || text_.front() >= static_cast<char>('A' + letters)) throw Refusal{"command"};
    const auto value = static_cast<unsigned>(text_.front() - 'A');
    text_.remove_prefix(1);
    return value;
  }

 private:
  std::string_view text_;
};

Command parse_move(Scanner scanner) {
  Move move;
  while (scanner.take("#")) {
    Target target{scanner.channel(), 0, std::nullopt};
    if (!scanner.take("P")) throw Refusal{"command"};
    target.pulse = scanner.number("pulse width", 0, longest_pulse);
    if (target.pulse != 0 && target.pulse < shortest_pulse) throw Refusal{"pulse width"};
    if (scanner.take("S")) target.speed = scanner.number("speed", 0, highest_number);
    move.targets.push_back(target);
  }
  if (scanner.take("T")) move.milliseconds = scanner.number("time", 0, highest_number);
  if (!scanner.done()) throw Refusal{"command"};
  return move;
}

Command parse_pulses(Scanner scanner) {
  QueryPulses query;
  while (scanner.take("QP")) query.channels.push_back(scanner.channel());
  if (!scanner.done()) throw Refusal{"command"};
  return query;
}

Command parse_analog(Scanner scanner) {
  ReadAnalog read;
  while (scanner.take("V")) read.inputs.push_back(scanner.letter(analog_inputs));
  if (!scanner.done() || read.inputs.size() > most_reads) throw Refusal{"command"};
  return read;
}

Command parse_digital(Scanner scanner) {
  ReadDigital read;
  while (!scanner.done()) {
    const unsigned input = scanner.letter(digital_inputs);
    read.inputs.push_back({input, scanner.take("L")});
  }
  if (read.inputs.size() > most_reads) throw Refusal{"command"};
  return read;
}

Command parse_words(std::string_view text) {
  if (text.empty()) return Nothing{};
  if (text == "Q") return QueryMovement{};
  if (text == "VER") return QueryVersion{};
  Scanner scanner(text);
  if (text.front() == '#') return parse_move(scanner);
  if (text.front() == 'Q') return parse_pulses(scanner);
  if (text.front() == 'V') return parse_analog(scanner);
  if (scanner.take("STOP")) {
    const Stop stop{scanner.channel()};
    if (!scanner.done()) throw Refusal{"command"};
    return stop;
  }
  return parse_digital(scanner);
}

}  // namespace

Command parse(std::string_view line) {
  std::string text;
  for (const char c : line) {
    if (c == ' ' || c == '\t' || c == '\n') continue;
    text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  try {
    return parse_words(text);
  } catch (const Refusal& refusal) {
    return Bad{refusal.reason};
  }
}

}  // namespace lamprey::robot_bridge::emulators::ssc32
