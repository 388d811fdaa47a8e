#pragma once

#include "science/neurons/neuron.hpp"
#include "science/neurons/on_off_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace lamprey::science::neurons {

/// T3 of eq. 6.5, the constant sum of on-time and off-time: twice the ten steps of a stride (6.2.1).
inline constexpr std::int32_t on_and_off_time = 20;

/// Eq. 6.5: a positive net is itself the on-time, in whole steps and at most T3; the rest of T3 is the off-time. A net
/// of 0 or less doesn't fire. A net below 1 has an on-time of 0, and so an off-time of T3.
constexpr OnOffState cycle_of_net(double net) {
  if (!(net > 0)) return {};
  const auto on_time = static_cast<std::int32_t>(std::min(net, double{on_and_off_time}));
  return {on_time, on_and_off_time - on_time};
}

/// The on/off neuron without a threshold of 6.2.2.6 (eq. 6.5), of which only the weights evolve. As a modification of
/// the neuron of 6.2.2.2 it keeps that one's acting output.
struct NetAsOnTimeNeuron {
  using State = OnOffState;
  static constexpr std::size_t times = 0;
  static constexpr bool has_threshold = false;
  /// Whole, as all weights of 6.2.2.7 are: it draws them by the generator of 4.2.3, which makes whole numbers. Drawn as
  /// reals, a weight would never be the ±10 that alone gives a feed-forward pair strides of ten steps.
  static constexpr WeightRange weights{-10, 10, true};

  static NetAsOnTimeNeuron from_genes(std::span<const double>, double) { return {}; }
};

inline NeuronOutput step(const NetAsOnTimeNeuron&, double net, OnOffState& state) {
  if (listens(state)) state = cycle_of_net(net);
  return run_cycle_announcing_off(state);
}

static_assert(PairNeuron<NetAsOnTimeNeuron>);

}  // namespace lamprey::science::neurons
