#pragma once

#include "science/neurons/neuron.hpp"
#include "science/saving/archive.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace lamprey::science::neurons {

/// In steps: networks::maximum_time.
inline constexpr std::int32_t longest_pulse = 100;

/// McMinn's time-dependent neuron (2.6.1, 6.2.2): +1 for a certain time once the net is above the threshold, else 0.
/// A pulse starts where the net rises above the threshold, one for each such crossing: a net that stays above gives a
/// single pulse, and has to fall back before the next. A crossing during a pulse neither lengthens it nor is kept.
struct TimedNeuron {
  std::int32_t time = 1;  ///< length of a pulse in whole time steps; 0 or more
  double threshold = 0;

  struct State {
    std::int32_t pulse_steps = 0;  ///< that remain
    bool above = false;            ///< the net was above the threshold in the step before

    bool operator==(const State&) const = default;
  };
  static constexpr std::size_t times = 1;
  static constexpr bool has_threshold = true;
  static constexpr WeightRange weights = chapter_6_weights;

  /// The time is never negative and is rounded down.
  static TimedNeuron from_genes(std::span<const double> time_genes, double threshold) {
    return {static_cast<std::int32_t>(time_genes[0]), threshold};
  }
};

void fields(auto& archive, saving::Of<TimedNeuron::State> auto& state) {
  archive.whole("pulse_steps", state.pulse_steps, 0, longest_pulse);
  archive.flag("above", state.above);
}

inline NeuronOutput step(const TimedNeuron& neuron, double net, TimedNeuron::State& state) {
  const bool above = net > neuron.threshold;
  if (state.pulse_steps == 0 && above && !state.above) state.pulse_steps = neuron.time;
  state.above = above;
  if (state.pulse_steps == 0) return {0, 0};
  --state.pulse_steps;
  return {1, 1};
}

static_assert(PairNeuron<TimedNeuron>);

}  // namespace lamprey::science::neurons
