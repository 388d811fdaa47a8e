#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What a robot was asked for and what it reported in one attempt of a job, as it came over the network
/// (idl/recording.proto) and as it is stored.
namespace lamprey::storage {

/// Of the one kind of robot that there is; science/robots/quadruped.hpp numbers them.
inline constexpr std::size_t robot_servos = 8;
inline constexpr std::size_t robot_legs = 4;

/// Positions are in hundredths of the robot's units.
inline constexpr double position_unit = 100;

// Bounds of a recording: beyond them it is nothing that a worker of ours sends.
inline constexpr std::int32_t furthest_position = 100'000;         ///< either way: 1000 units
inline constexpr std::uint64_t most_recorded_values = 10'000'000;  ///< positions and feet together
inline constexpr std::uint32_t most_tries_of_evaluation = 20;      ///< in a row; then a worker gives the job up
inline constexpr std::uint64_t most_tries = 100'000;               ///< of all evaluations
inline constexpr std::size_t most_recording_bytes = std::size_t{32} << 20;
inline constexpr std::size_t longest_void_reason = 4096;

/// One try of an evaluation. Of each list the first row is what the evaluation began with: T time steps have T + 1
/// rows; a try that was void before it began has none.
struct RobotTry {
  std::uint32_t evaluation = 0;              ///< of the job, from 0
  std::uint32_t attempt = 0;                 ///< of this evaluation, from 0
  std::string voided = {};                   ///< why it is worth nothing; empty: it counts
  bool measured = false;                     ///< `reported` is from sensors; else the device interpolates its commands
  std::vector<std::int32_t> commanded = {};  ///< after all limits; robot_servos per row
  std::vector<std::int32_t> reported = {};   ///< likewise
  std::vector<std::int32_t> feet_down = {};  ///< a bit per leg; one per row

  std::uint64_t time_steps() const { return feet_down.empty() ? 0 : feet_down.size() - 1; }
  bool operator==(const RobotTry&) const = default;
};

struct RobotRecording {
  std::string robot;                 ///< 1 to 64 of A–Z a–z 0–9 _ . -
  std::uint64_t token = 0;           ///< of the claim that it was moved under
  std::vector<RobotTry> tries = {};  ///< in order: those of an evaluation that are void, then the one that counts
  bool operator==(const RobotRecording&) const = default;
};

/// The recording in the octets of an idl::RobotRecording; or why it is refused: it is malformed, beyond the bounds
/// above or contradicts itself. What is read takes memory in proportion to the octets. Thread-safe.
struct ParsedRecording {
  std::optional<RobotRecording> recording;
  std::string refusal;
};
ParsedRecording parse_recording(std::span<const std::uint8_t> octets);

/// What is wrong with the recording by the same rules; empty if nothing is.
std::string recording_fault(const RobotRecording& recording);

/// The columns commanded, reported and feet: `[1000,-25,…]` without white space. Replaces what `text` holds and keeps
/// its memory.
void write_whole_numbers(std::span<const std::int32_t> numbers, std::string& text);

/// The inverse; nothing if the text is not exactly what write_whole_numbers makes.
std::optional<std::vector<std::int32_t>> read_whole_numbers(std::string_view text);

}  // namespace lamprey::storage
