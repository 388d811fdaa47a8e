#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lamprey::robot_bridge::emulators::ssc32 {

inline constexpr unsigned channels = 32;
inline constexpr int shortest_pulse = 500;  ///< µs
inline constexpr int longest_pulse = 2500;
inline constexpr unsigned digital_inputs = 6;  ///< A..F
inline constexpr unsigned analog_inputs = 8;   ///< A..H

// What a line can be. SSC-32U user guide, "Commands" and "Advanced functions":
//   move      = 1*( "#" channel "P" pulse [ "S" speed ] ) [ "T" time ]
//   stop      = "STOP" channel
//   movement  = "Q"
//   pulses    = 1*( "QP" channel )
//   version   = "VER"
//   digital   = 1*8( "A".."F" [ "L" ] )
//   analog    = 1*8( "V" "A".."H" )
// in either case; spaces, tabs and line feeds are ignored.

struct Target {
  unsigned channel;
  int pulse;                 ///< µs; 0 turns the servo off
  std::optional<int> speed;  ///< at most, in µs per second
};
struct Move {
  std::vector<Target> targets;
  std::optional<int> milliseconds;  ///< at least
};
struct Stop {
  unsigned channel;
};
struct QueryMovement {};
struct QueryPulses {
  std::vector<unsigned> channels;
};
struct QueryVersion {};
struct DigitalInput {
  unsigned input;
  bool latched;
};
struct ReadDigital {
  std::vector<DigitalInput> inputs;
};
struct ReadAnalog {
  std::vector<unsigned> inputs;
};
/// A line without anything on it.
struct Nothing {};
/// A line that the controller drops in silence.
struct Bad {
  std::string reason;
};

using Command =
    std::variant<Nothing, Bad, Move, Stop, QueryMovement, QueryPulses, QueryVersion, ReadDigital, ReadAnalog>;

/// What a line says, without its carriage return.
Command parse(std::string_view line);

}  // namespace lamprey::robot_bridge::emulators::ssc32
