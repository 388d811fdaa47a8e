#pragma once

#include "science/neurons/neuron.hpp"
#include "science/saving/archive.hpp"

#include <cstdint>

namespace lamprey::science::neurons {

// What the on/off neurons of 6.2.2 share: once fired, a neuron puts out +1 for its on-time, then −1 for its off-time,
// and does not consider its inputs meanwhile; otherwise it puts out −1.

/// Steps that remain of the present cycle; none of either: the neuron listens.
struct OnOffState {
  std::int32_t on_steps = 0;
  std::int32_t off_steps = 0;

  bool operator==(const OnOffState&) const = default;
};

/// No neuron fires or pauses for longer, in steps: networks::maximum_time.
inline constexpr std::int32_t longest_phase = 100;

void fields(auto& archive, saving::Of<OnOffState> auto& state) {
  archive.whole("on_steps", state.on_steps, 0, longest_phase);
  archive.whole("off_steps", state.off_steps, 0, longest_phase);
}

constexpr bool listens(const OnOffState& state) {
  return state.on_steps == 0 && state.off_steps == 0;
}

/// One step of a cycle that runs, or of rest. Others see what the robot sees.
constexpr NeuronOutput run_cycle(OnOffState& state) {
  if (state.on_steps > 0) {
    --state.on_steps;
    return {1, 1};
  }
  if (state.off_steps > 0) --state.off_steps;
  return {-1, -1};
}

/// The same with the acting output of 6.2.2.2: on the last on-step others see −1 already, as the neuron is about to
/// change its state. The change back is not announced.
constexpr NeuronOutput run_cycle_announcing_off(OnOffState& state) {
  const bool last_on_step = state.on_steps == 1;
  NeuronOutput output = run_cycle(state);
  if (last_on_step) output.acting = -1;
  return output;
}

}  // namespace lamprey::science::neurons
