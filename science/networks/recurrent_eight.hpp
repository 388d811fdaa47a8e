#pragma once

#include "science/networks/cycle.hpp"
#include "science/saving/archive.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace lamprey::science::networks {

// The recurrent network of 7.4.2 (figs 7.14 to 7.16): eight neurons of eq. 7.10, each with inputs from three others.
//   Net_j = Σ In_i·W_i; Net_j > 0 triggers the ON/OFF cycle (fig. 7.11), else the output is 0.

/// Which child neuron N1..N8 of 7.4.2 is, by its times (fig. 7.13): N2 swings the back left leg, first of all (7.4.1),
/// then N6 the front left, N1 the back right and N5 the front right; N4, N8, N3 and N7 lift them.
constexpr std::size_t child_of_neuron(std::size_t number) {
  return children - number;
}

inline constexpr std::size_t inputs_per_neuron = 3;
/// The children from which each child has its inputs: the links of fig. 7.15, which are mutual.
inline constexpr std::array<std::array<std::uint8_t, inputs_per_neuron>, children> input_children{
    {{4, 3, 1}, {5, 2, 0}, {6, 3, 1}, {7, 2, 0}, {7, 5, 0}, {6, 4, 1}, {7, 5, 2}, {6, 4, 3}}};

struct RecurrentNeuron {
  ChildTimes times{};
  /// −1..1, by input_children.
  std::array<double, inputs_per_neuron> weights{};

  bool operator==(const RecurrentNeuron&) const = default;
};

struct RecurrentEightNetwork {
  std::array<RecurrentNeuron, children> neurons{};
  /// Whether D1 delays every firing, as eq. 7.10 reads, or only a neuron's first: fig. 7.16 follows only so.
  bool delay_refirings = true;

  bool operator==(const RecurrentEightNetwork&) const = default;
};

struct RecurrentEightSteps {
  CycleSteps cycles;
  std::array<std::array<double, inputs_per_neuron>, children> weights;
  bool delay_refirings;
};

RecurrentEightSteps whole_steps(const RecurrentEightNetwork& network);

struct RecurrentEightState {
  CyclePlaces places = all_waiting();
  std::array<bool, children> has_fired{};
  ChildOutputs outputs{-1, -1, -1, -1, -1, -1, -1, -1};  ///< of the step before; at first the initial inputs (7.4.2)

  bool operator==(const RecurrentEightState&) const = default;
};

void fields(auto& archive, saving::Of<RecurrentEightState> auto& state) {
  places(archive, state.places);
  saving::flags(archive, "has_fired", state.has_fired);
  saving::wholes(archive, "outputs", state.outputs, -1, 1);
}

/// The net of child i: its inputs are the outputs of the step before.
inline double net(const RecurrentEightSteps& steps, const ChildOutputs& outputs, std::size_t i) {
  double sum = 0;
  for (std::size_t input = 0; input < inputs_per_neuron; ++input) {
    sum += steps.weights[i][input] * outputs[input_children[i][input]];
  }
  return sum;
}

/// One time step: nets are calculated anew for neurons that are not in a cycle. Pure but for `state`.
inline ChildOutputs step(const RecurrentEightSteps& steps, RecurrentEightState& state) {
  for (std::size_t i = 0; i < children; ++i) {
    if (!waits(steps.cycles, state.places, i)) continue;
    if (net(steps, state.outputs, i) > 0) {
      const bool delayed = steps.delay_refirings || !state.has_fired[i];
      state.places[i] = delayed ? std::int16_t{0} : steps.cycles.on_opens[i];
      state.has_fired[i] = true;
    } else {
      state.places[i] = waiting;
    }
  }
  state.outputs = advance_cycles(steps.cycles, state.places);
  return state.outputs;
}

}  // namespace lamprey::science::networks
