#include "science/networks/split_generator.hpp"

namespace lamprey::science::networks {

SplitGeneratorSteps whole_steps(const SplitGenerator& network) {
  const std::array<double, 2> times{network.oscillator_on_time, network.oscillator_off_time};
  SplitGeneratorSteps steps{};
  steps.oscillator = neurons::ActingOutputNeuron::from_genes(times, oscillator_threshold);
  for (std::size_t i = 0; i < children; ++i) {
    const PatternNeuron& neuron = network.pattern[i];
    steps.pattern[i] = neurons::TimedNeuron::from_genes(std::array{neuron.time}, neuron.threshold);
    steps.weights[i] = neuron.weights;
  }
  return steps;
}

ChildLevels step(const SplitGeneratorSteps& steps, SplitGeneratorState& state) {
  std::array<neurons::NeuronOutput, oscillator_neurons> oscillator;
  for (std::size_t i = 0; i < oscillator_neurons; ++i) {
    const double net = oscillator_weight * state.acting[1 - i];
    oscillator[i] = neurons::step(steps.oscillator, net, state.oscillator[i]);
  }
  for (std::size_t i = 0; i < oscillator_neurons; ++i) state.acting[i] = oscillator[i].acting;

  ChildLevels levels;
  for (std::size_t i = 0; i < children; ++i) {
    const double net = steps.weights[i][0] * oscillator[0].out + steps.weights[i][1] * oscillator[1].out;
    levels[i] = standing_level + pulse_stroke * neurons::step(steps.pattern[i], net, state.pattern[i]).out;
  }
  return levels;
}

}  // namespace lamprey::science::networks
