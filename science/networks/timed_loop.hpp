#pragma once

#include "science/networks/children.hpp"
#include "science/saving/archive.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace lamprey::science::networks {

// The counter-example of 9.2: no network at all, but a software loop that switches each servo on and off at set times.
// The RTEA tunes the times directly.

/// When a servo runs, in time steps from the loop's beginning; reals within minimum_time..maximum_time: forward at a
/// for b steps, backward at c for d steps.
using LoopTimes = std::array<double, 4>;
enum LoopTime : std::uint8_t { forward_at = 0, forward_for = 1, backward_at = 2, backward_for = 3 };

struct TimedLoop {
  std::array<LoopTimes, children> servo_times{};
  std::int32_t period = 1;  ///< of the loop, in time steps, at least 1; a constant of the gait

  bool operator==(const TimedLoop&) const = default;
};

struct TimedLoopSteps {
  std::array<std::int16_t, children> forward_opens;
  std::array<std::int16_t, children> forward_closes;
  std::array<std::int16_t, children> backward_opens;
  std::array<std::int16_t, children> backward_closes;
  std::int16_t period;
};

/// Times are rounded down to whole steps.
TimedLoopSteps whole_steps(const TimedLoop& loop);

struct TimedLoopState {
  std::int16_t elapsed = 0;  ///< of the loop's present round

  bool operator==(const TimedLoopState&) const = default;
};

void fields(auto& archive, saving::Of<TimedLoopState> auto& state) {
  // One short of the largest: the next step must not run over.
  archive.whole("elapsed", state.elapsed, 0, std::int16_t{32'766});
}

/// One time step. A servo switched both ways stands still; what is still on at the loop's end is switched off. Pure but
/// for `state`.
inline ChildOutputs step(const TimedLoopSteps& steps, TimedLoopState& state) {
  ChildOutputs outputs;
  for (std::size_t i = 0; i < children; ++i) {
    const int forward = within(state.elapsed, steps.forward_opens[i], steps.forward_closes[i]);
    const int backward = within(state.elapsed, steps.backward_opens[i], steps.backward_closes[i]);
    outputs[i] = static_cast<std::int16_t>(forward - backward);
  }
  const auto next = static_cast<std::int16_t>(state.elapsed + 1);
  state.elapsed = next < steps.period ? next : std::int16_t{0};
  return outputs;
}

}  // namespace lamprey::science::networks
