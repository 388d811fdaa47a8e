#include "science/networks/recurrent_eight.hpp"

namespace lamprey::science::networks {

RecurrentEightSteps whole_steps(const RecurrentEightNetwork& network) {
  RecurrentEightSteps steps{};
  std::array<ChildTimes, children> times;
  for (std::size_t i = 0; i < children; ++i) {
    times[i] = network.neurons[i].times;
    steps.weights[i] = network.neurons[i].weights;
  }
  steps.cycles = whole_steps(times);
  steps.delay_refirings = network.delay_refirings;
  return steps;
}

}  // namespace lamprey::science::networks
