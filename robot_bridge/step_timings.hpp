#pragma once

#include "robot_bridge/histogram.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lamprey::robot_bridge {

/// How long the parts of time steps have taken, by the step's number within its evaluation: what is slow at the
/// beginning of each evaluation, or at one step of a gait, is not seen in a mean over all. A value; not thread-safe.
class StepTimings {
 public:
  /// The steps from this number on share their figures, so that its size has a bound whatever is asked for.
  static constexpr std::uint32_t most_steps = 256;

  struct Step {
    std::uint64_t late = 0;  ///< began later than a quarter of a period after they were due
    Histogram command_to_line;
    Histogram line_to_state;
    Histogram jitter;  ///< from when they were due to their beginnings; none for the first step
  };

  /// All its memory is taken here: who adds is in a hurry.
  StepTimings() { steps_.reserve(most_steps); }

  void add(std::uint32_t time_step, std::chrono::nanoseconds command_to_line, std::chrono::nanoseconds line_to_state);
  void add_jitter(std::uint32_t time_step, std::chrono::nanoseconds jitter, bool late);

  /// By number; those after the highest that was made are missing.
  const std::vector<Step>& steps() const { return steps_; }

 private:
  Step& step(std::uint32_t time_step);

  std::vector<Step> steps_;
};

/// A CSV table with a line per step and part, times in µs:
/// `time_step,part,count,late,median,percentile_99,largest`; `late` is told of the jitter only.
std::string to_csv(const StepTimings& timings);

}  // namespace lamprey::robot_bridge
