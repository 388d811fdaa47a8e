#pragma once

#include "messaging/robot_samples.hpp"
#include "robot_bridge/claims.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace lamprey::robot_bridge {

/// What the gate has turned away, by reason.
struct GateCounters {
  std::uint64_t accepted = 0;
  std::uint64_t under_no_claim =
      0;                          ///< with a token that is not the claim's: an old one, or none that was ever granted
  std::uint64_t repeated = 0;     ///< of a step that was made already
  std::uint64_t of_void = 0;      ///< of an evaluation that is void or over
  std::uint64_t not_numbers = 0;  ///< with positions that are no finite numbers
  std::uint64_t voided = 0;       ///< evaluations
};

/// Lets the commands of an evaluation through one after the other, each once, and voids an evaluation of which one is
/// missing, late or out of order: what the robot did then is not what was asked for. Not thread-safe.
class CommandGate {
 public:
  /// `grace`: a command may come so long after the state of the step before it.
  explicit CommandGate(Clock::duration grace) : grace_(grace) {}

  struct Decision {
    bool accepted = false;
    std::string voided;  ///< why the command's evaluation is void from now on; empty if it isn't, or was before
  };
  Decision look(const messaging::ServoCommand& command, const Claims& claims, Clock::time_point now);

  /// The step that was let through last has been made.
  void step_done(Clock::time_point now);

  /// Voids the evaluation that is going on, if there is one; whether there was.
  bool abandon();

  /// Why the evaluation that goes on is void, as its next command has not come in time.
  std::optional<std::string> overdue(Clock::time_point now);

  bool evaluating() const { return running_; }
  std::uint64_t token() const { return token_; }
  std::uint64_t evaluation() const { return evaluation_; }
  /// The step that was let through last.
  std::uint32_t time_step() const { return next_step_ == 0 ? 0 : next_step_ - 1; }
  const GateCounters& counters() const { return counters_; }

 private:
  Decision voided(const std::string& reason);
  Decision next(const messaging::ServoCommand& command);

  Clock::duration grace_;
  std::uint64_t token_ = 0;
  std::uint64_t evaluation_ = 0;  ///< the newest of this token; 0: none yet
  std::uint32_t next_step_ = 0;
  bool running_ = false;  ///< between the first and the last step
  bool moving_ = false;   ///< the last step that was let through is being made
  Clock::time_point deadline_{};
  GateCounters counters_;
};

}  // namespace lamprey::robot_bridge
