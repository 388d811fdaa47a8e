#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace lamprey::science::neurons {

/// What a neuron does in one time step.
struct NeuronOutput {
  std::int16_t out = 0;     ///< to the robot: −1, 0 or +1
  std::int16_t acting = 0;  ///< to the neurons it is connected to (6.2.2.2); the same in most models

  bool operator==(const NeuronOutput&) const = default;
};

/// Between which bounds a model's weights evolve.
struct WeightRange {
  double minimum;
  double maximum;
  bool whole = false;  ///< drawn as whole numbers only
};

/// A neuron model of a network whose topology doesn't depend on it: its parameters, with the state's type and what
/// evolves. In a chromosome a neuron has its times, the weights of its connections, its threshold (figs 6.23, 6.24).
/// `step` is one time step with net input `net`, pure but for the state; a default state is before the first step.
template <typename Neuron>
concept PairNeuron = std::is_trivially_copyable_v<typename Neuron::State> &&
    std::default_initializable<typename Neuron::State> &&
    requires(const Neuron& neuron, typename Neuron::State& state, std::span<const double> genes) {
  { Neuron::times } -> std::convertible_to<std::size_t>;
  { Neuron::has_threshold } -> std::convertible_to<bool>;
  { Neuron::weights } -> std::convertible_to<WeightRange>;
  { Neuron::from_genes(genes, 0.0) } -> std::same_as<Neuron>;
  { step(neuron, 0.0, state) } -> std::same_as<NeuronOutput>;
};

/// Weights and thresholds of chapter 6 start between 0 and 1 (6.2.2.4).
inline constexpr WeightRange chapter_6_weights{0, 1};

}  // namespace lamprey::science::neurons
