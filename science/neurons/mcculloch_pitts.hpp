#pragma once

#include "science/neurons/neuron.hpp"
#include "science/saving/archive.hpp"

#include <cstddef>
#include <span>

namespace lamprey::science::neurons {

/// The neuron of McCulloch and Pitts (1943) that McMinn began with (2.6.1): 1 while its net reaches the threshold,
/// else 0. It has no sense of time.
struct McCullochPittsNeuron {
  double threshold = 0;

  struct State {
    bool operator==(const State&) const = default;
  };
  static constexpr std::size_t times = 0;
  static constexpr bool has_threshold = true;
  static constexpr WeightRange weights = chapter_6_weights;

  static McCullochPittsNeuron from_genes(std::span<const double>, double threshold) { return {threshold}; }
};

void fields(auto& /*archive*/, saving::Of<McCullochPittsNeuron::State> auto& /*state*/) {}

inline NeuronOutput step(const McCullochPittsNeuron& neuron, double net, McCullochPittsNeuron::State&) {
  return net >= neuron.threshold ? NeuronOutput{1, 1} : NeuronOutput{0, 0};
}

static_assert(PairNeuron<McCullochPittsNeuron>);

}  // namespace lamprey::science::neurons
