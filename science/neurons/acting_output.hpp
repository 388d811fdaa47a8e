#pragma once

#include "science/neurons/threshold.hpp"

#include <span>

namespace lamprey::science::neurons {

/// The on/off neuron of eq. 6.3 with the acting output of 6.2.2.2: on its last on-step it shows other neurons, and
/// itself, −1, so that its partner can start in the very step in which it stops (figs 6.16, 6.17).
struct ActingOutputNeuron : ThresholdNeuron {
  static ActingOutputNeuron from_genes(std::span<const double> time_genes, double threshold) {
    return {ThresholdNeuron::from_genes(time_genes, threshold)};
  }
};

inline NeuronOutput step(const ActingOutputNeuron& neuron, double net, OnOffState& state) {
  fire_above_threshold(neuron, net, state);
  return run_cycle_announcing_off(state);
}

static_assert(PairNeuron<ActingOutputNeuron>);

}  // namespace lamprey::science::neurons
