#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// What a robot's bridge and those who use the robot say to each other, as neutral value types; idl/robot.idl has the
/// same fields for the wire. Everything in them that came from the network is unchecked input.
namespace lamprey::messaging {

inline constexpr std::size_t servos = 8;
/// A position per servo in the robot's units, 0..30, numbered as in science/robots/quadruped.hpp.
using ServoPositions = std::array<double, servos>;

enum class RobotState : std::uint8_t {
  unconfigured = 0,  ///< no device yet: the line is being opened, or nothing answers
  inactive = 1,      ///< the device answers; positions are read, nothing is moved
  active = 2,        ///< servos are on and hold; who holds the claim moves them
  fault = 3,         ///< the device failed while it was active; the bridge is getting it back
  finalized = 4,     ///< the bridge has ended
};

struct RobotCounter {
  std::string name;  ///< [a-z_]+
  std::uint64_t value = 0;
  bool operator==(const RobotCounter&) const = default;
};

/// Bridge → anyone: heartbeat and all there is to know of the robot. Key: robot.
struct RobotStatus {
  std::uint64_t robot = 0;
  std::string name;
  RobotState state = RobotState::unconfigured;
  bool stopped = false;           ///< emergency stop: latched until somebody resets it
  std::string reason;             ///< of the fault or the stop
  std::uint64_t incarnation = 0;  ///< random, of this process
  std::uint64_t heartbeat = 0;    ///< counts up from 1
  std::uint64_t token = 0;        ///< of the newest claim
  std::uint64_t holder = 0;       ///< whose claim it is; 0: nobody's
  double rate = 0;                ///< time steps per second
  std::string driver;
  std::string device;      ///< what the driver has found
  std::string scheduling;  ///< class and priority in force
  std::string host;
  std::uint32_t process = 0;
  std::string build;
  std::string dds;
  std::vector<RobotCounter> counters;
  bool operator==(const RobotStatus&) const = default;
};

enum class RobotRequestKind : std::uint8_t {
  claim = 0,       ///< or renew the claim of `token`
  release = 1,     ///< the claim of `token`
  stop = 2,        ///< emergency stop: anybody may
  reset = 3,       ///< of the emergency stop, by hand
  activate = 4,    ///< servos on; `confirmed`: somebody has seen that the robot stands as its first pose has it
  deactivate = 5,  ///< servos off
  place = 6,       ///< with the claim: go to `position`, at the slew rate; granted when it is there
};

/// Worker, client → one bridge. Sent again, with the same correlation, until there is a reply.
struct RobotRequest {
  std::uint64_t robot = 0;
  std::uint64_t asker = 0;        ///< names the asker's partition
  std::uint64_t correlation = 0;  ///< the same for a repeated request
  RobotRequestKind kind = RobotRequestKind::claim;
  std::uint64_t token = 0;
  bool confirmed = false;
  ServoPositions position{};
  std::string reason;  ///< of a stop
  bool operator==(const RobotRequest&) const = default;
};

/// Bridge → one asker.
struct RobotReply {
  std::uint64_t robot = 0;
  std::uint64_t asker = 0;
  std::uint64_t correlation = 0;
  bool granted = false;
  std::string reason;  ///< of a refusal
  std::uint64_t token = 0;
  std::uint32_t lease_milliseconds = 0;  ///< of a claim, on the bridge's steady clock; commands renew it
  RobotState state = RobotState::unconfigured;
  bool stopped = false;
  bool operator==(const RobotReply&) const = default;
};

/// Worker → one bridge: where the servos are to be at the end of the time step.
struct ServoCommand {
  std::uint64_t robot = 0;
  std::uint64_t token = 0;
  std::uint64_t evaluation = 0;  ///< of this claim: counts up with each try
  std::uint32_t time_step = 0;   ///< 0-based, within the evaluation
  bool last = false;             ///< of the evaluation: none is to be missed after it
  ServoPositions position{};
  bool operator==(const ServoCommand&) const = default;
};

enum class StepOutcome : std::uint8_t {
  done = 0,
  voided = 1,  ///< for `reason`; the evaluation is worth nothing and is to be tried again
};

/// Bridge → whoever listens to this robot: what a time step has come to.
struct ServoState {
  std::uint64_t robot = 0;
  std::uint64_t token = 0;
  std::uint64_t evaluation = 0;
  std::uint32_t time_step = 0;
  StepOutcome outcome = StepOutcome::done;
  std::string reason;
  ServoPositions commanded{};                     ///< what was sent to the device, after all limits
  ServoPositions reported{};                      ///< what the device says
  bool measured = false;                          ///< by sensors; else the device interpolates its commands
  std::uint32_t feet_down = 0;                    ///< a bit per leg, 1 << science::robots::Leg
  std::uint64_t command_to_line_nanoseconds = 0;  ///< from the command's arrival to its last octet's write
  std::uint64_t line_to_state_nanoseconds = 0;    ///< from there to the device's answer
  bool operator==(const ServoState&) const = default;
};

}  // namespace lamprey::messaging
