#include "robot_bridge/drivers/ssc32_protocol.hpp"

#include <algorithm>

namespace lamprey::robot_bridge::drivers::ssc32 {

namespace {

constexpr char escape = '\x1b';
constexpr std::int64_t longest_milliseconds = 65535;
constexpr std::string_view first_of_version = "SSC32";

std::string positions(std::span<const ServoPulse> servos) {
  std::string text;
  for (const auto& [channel, pulse] : servos) text += '#' + std::to_string(channel) + 'P' + std::to_string(pulse);
  return text;
}

}  // namespace

std::string version_query() {
  return std::string(1, escape) + "VER\r";
}

std::string move_command(std::span<const ServoPulse> servos, std::chrono::microseconds duration) {
  const auto rounded = std::chrono::round<std::chrono::milliseconds>(duration).count();
  const auto milliseconds = std::clamp<std::int64_t>(rounded, 1, longest_milliseconds);
  return positions(servos) + 'T' + std::to_string(milliseconds) + '\r';
}

std::string start_command(std::span<const ServoPulse> servos) {
  return positions(servos) + '\r';
}

std::string stop_commands(std::span<const std::int32_t> channels) {
  std::string text;
  for (const auto channel : channels) text += "STOP" + std::to_string(channel) + '\r';
  return text;
}

std::string release_command(std::span<const std::int32_t> channels) {
  std::string text(1, escape);
  for (const auto channel : channels) text += '#' + std::to_string(channel) + "P0";
  return text + '\r';
}

std::string pulse_query(std::span<const std::int32_t> channels) {
  std::string text;
  for (const auto channel : channels) text += "QP" + std::to_string(channel);
  return text + '\r';
}

std::string input_query(std::span<const std::int32_t> inputs) {
  std::string text;
  for (const auto input : inputs) text += static_cast<char>('A' + input);
  return text.empty() ? text : text + '\r';
}

std::string movement_query() {
  return "Q\r";
}

std::optional<bool> is_moving(std::span<const std::uint8_t> answer) {
  if (answer.size() != 1 || (answer[0] != '+' && answer[0] != '.')) return std::nullopt;
  return answer[0] == '+';
}

std::optional<std::string> version_of(std::span<const std::uint8_t> answer) {
  const std::string text(answer.begin(), answer.end());
  const bool is_text = std::ranges::all_of(text, [](char letter) { return letter >= ' ' && letter <= '~'; });
  if (!is_text || !text.starts_with(first_of_version)) return std::nullopt;
  return text;
}

std::optional<std::vector<std::int32_t>> tens_of_microseconds(std::span<const std::uint8_t> answer) {
  const auto is_pulse = [](std::uint8_t tens) {
    return tens == 0 || (tens >= lowest_pulse / 10 && tens <= highest_pulse / 10);
  };
  if (!std::ranges::all_of(answer, is_pulse)) return std::nullopt;
  return std::vector<std::int32_t>(answer.begin(), answer.end());
}

std::optional<std::vector<bool>> input_levels(std::span<const std::uint8_t> answer) {
  std::vector<bool> levels;
  for (const auto octet : answer) {
    if (octet != '0' && octet != '1') return std::nullopt;
    levels.push_back(octet == '1');
  }
  return levels;
}

}  // namespace lamprey::robot_bridge::drivers::ssc32
