#pragma once

#include "science/evolution/gene_plan.hpp"
#include "science/neurons/neuron.hpp"
#include "science/saving/archive.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace lamprey::science::networks {

// Networks of two neurons, N1 and N2, of any model, each of which drives a leg of the biped (6.2.2). Here N1 has
// number 0, N2 has 1.

inline constexpr std::size_t pair_size = 2;

/// A network of either topology: where neurons are not connected the weight is 0.
template <neurons::PairNeuron Neuron>
struct Pair {
  std::array<Neuron, pair_size> neuron{};
  /// weight[to][from]: W21, from N2 to N1, is weight[0][1].
  std::array<std::array<double, pair_size>, pair_size> weight{};
};

template <neurons::PairNeuron Neuron>
struct PairState {
  std::array<typename Neuron::State, pair_size> neuron{};
  /// input[to][from]. At first all inputs of N1 are −1 and all of N2 +1, whichever neuron they come from (6.2.2.1).
  std::array<std::array<std::int16_t, pair_size>, pair_size> input{{{-1, -1}, {1, 1}}};
};

template <typename Archive, typename State>
void pair_fields(Archive& archive, State& state) {
  for (auto& neuron : state.neuron) fields(archive, neuron);
  for (auto& row : state.input) saving::wholes(archive, "input", row, -1, 1);
}

/// What the network did in one time step.
struct PairStep {
  std::array<double, pair_size> net{};
  std::array<std::int16_t, pair_size> out{};     ///< to the legs
  std::array<std::int16_t, pair_size> acting{};  ///< the next step's inputs
};

/// One time step (6.2.2.1): both nets are the sums of inputs and weights, the partner's first, evaluated at the same
/// time from what the neurons showed in the step before. Pure but for `state`.
template <neurons::PairNeuron Neuron>
PairStep step(const Pair<Neuron>& network, PairState<Neuron>& state) {
  PairStep result;
  for (std::size_t self = 0; self < pair_size; ++self) {
    const std::size_t partner = 1 - self;
    result.net[self] = state.input[self][partner] * network.weight[self][partner] +
                       state.input[self][self] * network.weight[self][self];
    const neurons::NeuronOutput output = step(network.neuron[self], result.net[self], state.neuron[self]);
    result.out[self] = output.out;
    result.acting[self] = output.acting;
  }
  state.input = {result.acting, result.acting};
  return result;
}

/// Genes per neuron. `Topology` says which neurons each one receives from, in the chromosome's order.
template <typename Topology, neurons::PairNeuron Neuron>
constexpr std::size_t pair_neuron_genes() {
  return Neuron::times + Topology::sources[0].size() + (Neuron::has_threshold ? 1 : 0);
}

/// The chromosome (figs 6.23, 6.24, 6.28): for N1 and then for N2 the times, 1 to 10 steps, the weights and the
/// threshold, 0 to 1 (6.2.2.4). A unit per neuron; both are of one kind.
template <typename Topology, neurons::PairNeuron Neuron>
evolution::GenePlan pair_plan(const neurons::WeightRange& weights) {
  constexpr evolution::Gene time{.minimum = 1, .maximum = 10, .step_unit = 1, .whole = true};
  const evolution::Gene weight{.minimum = weights.minimum,
                               .maximum = weights.maximum,
                               .step_unit = (weights.maximum - weights.minimum) / 10,
                               .whole = weights.whole};
  constexpr evolution::Gene threshold{.minimum = 0, .maximum = 1, .step_unit = 0.1, .whole = false};
  evolution::GenePlan plan;
  for (std::size_t self = 0; self < pair_size; ++self) {
    const std::size_t first = plan.genes.size();
    plan.genes.insert(plan.genes.end(), Neuron::times, time);
    plan.genes.insert(plan.genes.end(), Topology::sources[self].size(), weight);
    if constexpr (Neuron::has_threshold) plan.genes.push_back(threshold);
    auto& unit = plan.units.emplace_back();
    for (std::size_t gene = first; gene < plan.genes.size(); ++gene) unit.push_back(static_cast<std::uint32_t>(gene));
  }
  plan.kinds = {{0, 1}};
  return plan;
}

/// The network of a chromosome of pair_plan.
template <typename Topology, neurons::PairNeuron Neuron>
Pair<Neuron> pair_from_genes(std::span<const double> genes) {
  Pair<Neuron> network;
  for (std::size_t self = 0; self < pair_size; ++self) {
    const auto own = genes.subspan(self * pair_neuron_genes<Topology, Neuron>(), pair_neuron_genes<Topology, Neuron>());
    std::size_t gene = Neuron::times;
    for (const std::size_t from : Topology::sources[self]) network.weight[self][from] = own[gene++];
    double threshold = 0;
    if constexpr (Neuron::has_threshold) threshold = own[gene];
    network.neuron[self] = Neuron::from_genes(own.first(Neuron::times), threshold);
  }
  return network;
}

}  // namespace lamprey::science::networks
