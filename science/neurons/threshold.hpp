#pragma once

#include "science/neurons/neuron.hpp"
#include "science/neurons/on_off_cycle.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace lamprey::science::neurons {

/// The on/off neuron of eq. 6.3: a net above the threshold fires it, +1 for T_ON steps and −1 for T_OFF steps, the
/// first of them at once. At the threshold or below it puts out −1.
struct ThresholdNeuron {
  std::int32_t on_time = 1;   ///< T_ON, in whole time steps; 0 or more
  std::int32_t off_time = 1;  ///< T_OFF, likewise
  double threshold = 0;       ///< θ

  using State = OnOffState;
  static constexpr std::size_t times = 2;
  static constexpr bool has_threshold = true;
  static constexpr WeightRange weights = chapter_6_weights;

  /// `time_genes` are T_ON and T_OFF, never negative; they are rounded down.
  static ThresholdNeuron from_genes(std::span<const double> time_genes, double threshold) {
    return {static_cast<std::int32_t>(time_genes[0]), static_cast<std::int32_t>(time_genes[1]), threshold};
  }
};

/// Starts a cycle if the neuron listens and its net is above its threshold.
inline void fire_above_threshold(const ThresholdNeuron& neuron, double net, OnOffState& state) {
  if (listens(state) && net > neuron.threshold) state = {neuron.on_time, neuron.off_time};
}

inline NeuronOutput step(const ThresholdNeuron& neuron, double net, OnOffState& state) {
  fire_above_threshold(neuron, net, state);
  return run_cycle(state);
}

static_assert(PairNeuron<ThresholdNeuron>);

}  // namespace lamprey::science::neurons
