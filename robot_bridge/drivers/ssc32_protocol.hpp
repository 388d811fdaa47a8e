#pragma once

// The SSC-32's and SSC-32U's text protocol (Lynxmotion SSC-32U user guide, "Commands"): lines that end in a carriage
// return. Moves, stops and releases are not answered; queries are, without a frame.

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::robot_bridge::drivers::ssc32 {

inline constexpr std::uint8_t line_end = '\r';
inline constexpr std::int32_t lowest_pulse = 500;    ///< µs
inline constexpr std::int32_t highest_pulse = 2500;  ///< µs

struct ServoPulse {
  std::int32_t channel = 0;  ///< 0..31
  std::int32_t pulse = 0;    ///< µs
};

/// Ends what was written of a line before, and asks for the firmware's version.
std::string version_query();

/// One move of all servos, which end together: "#0P1500#1P1600T20\r". T has whole milliseconds, 1..65535; the duration
/// is rounded to that.
std::string move_command(std::span<const ServoPulse> servos, std::chrono::microseconds duration);

/// As fast as the servos can; a servo that was off goes there at once whatever a command says.
std::string start_command(std::span<const ServoPulse> servos);

/// "STOP0\rSTOP1\r": each where its pulse is now. Stops can't be grouped.
std::string stop_commands(std::span<const std::int32_t> channels);

/// Ends what was written of a line before; no pulses: "#0P0#1P0\r".
std::string release_command(std::span<const std::int32_t> channels);

/// "QP0QP1\r", answered by an octet per servo.
std::string pulse_query(std::span<const std::int32_t> channels);

/// "ABC\r" for the inputs 0, 1, 2; answered by '0' or '1' each. Empty where there are none.
std::string input_query(std::span<const std::int32_t> inputs);

/// "Q\r", answered by '+' while servos are on a move that was given a time, else by '.'.
std::string movement_query();

/// The version that an answer without its line end tells: text that begins with "SSC32". Nothing for anything else.
std::optional<std::string> version_of(std::span<const std::uint8_t> answer);

/// Pulses in units of 10 µs, 0 for servos that are off. Nothing where an octet is none that the device sends.
std::optional<std::vector<std::int32_t>> tens_of_microseconds(std::span<const std::uint8_t> answer);

/// Nothing where the answer is neither '+' nor '.'.
std::optional<bool> is_moving(std::span<const std::uint8_t> answer);

/// Whether each input is high. Nothing where an octet is neither '0' nor '1'.
std::optional<std::vector<bool>> input_levels(std::span<const std::uint8_t> answer);

/// Whether an octet of `tens_of_microseconds` tells this pulse. It is told with a unit of 10 µs, which firmware may
/// round or cut off.
constexpr bool tells_pulse(std::int32_t tens, std::int32_t pulse) {
  return tens == pulse / 10 || tens == (pulse + 5) / 10;
}

}  // namespace lamprey::robot_bridge::drivers::ssc32
