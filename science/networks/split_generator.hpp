#pragma once

#include "science/networks/children.hpp"
#include "science/neurons/acting_output.hpp"
#include "science/neurons/timed.hpp"
#include "science/saving/archive.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace lamprey::science::networks {

// McMinn's split generator (2.6.1, fig. 2.7): an evolved biped CPG is an oscillator that feeds a pattern generator,
// which makes the gait. The text names these parts and the gaits; the figure, which would show how they connect, is
// lost. The reading:
// - The oscillator is the biped's recurrent pair with acting outputs (6.2.2.2) as evolution leaves it: each neuron
//   fires when the other shows −1, the first one first. With T_ON = T_OFF they are in antiphase for ever.
// - The pattern generator is one of McMinn's timed neurons per servo, each fed by both neurons of the oscillator and by
//   nothing else: Net_j = W_1j·O_1 + W_2j·O_2.
// - A pulse of a timed neuron is a wanted position, not a direction (fig. 2.6 turns times into positions): pulse_stroke
//   above standing while it lasts, standing while there is none.

inline constexpr std::size_t oscillator_neurons = 2;

/// Of the two connections between the oscillator's neurons, and the threshold of both: those of 6.2.2.2's antiphase.
inline constexpr double oscillator_weight = -1;
inline constexpr double oscillator_threshold = 0.5;

/// In positions: the leg's swing in the walk (fig. 7.12).
inline constexpr double pulse_stroke = 10;
inline constexpr double standing_level = 10;

struct PatternNeuron {
  double threshold = 0;                              ///< 0..1
  double time = 0;                                   ///< of a pulse, within minimum_time..maximum_time
  std::array<double, oscillator_neurons> weights{};  ///< −1..1

  bool operator==(const PatternNeuron&) const = default;
};

struct SplitGenerator {
  std::array<PatternNeuron, children> pattern{};
  double oscillator_on_time = 1;   ///< T_ON of both neurons, within minimum_time..maximum_time
  double oscillator_off_time = 1;  ///< T_OFF, likewise

  bool operator==(const SplitGenerator&) const = default;
};

/// Times are rounded down to whole steps.
struct SplitGeneratorSteps {
  neurons::ActingOutputNeuron oscillator;
  std::array<neurons::TimedNeuron, children> pattern;
  std::array<std::array<double, oscillator_neurons>, children> weights;
};

SplitGeneratorSteps whole_steps(const SplitGenerator& network);

struct SplitGeneratorState {
  std::array<neurons::OnOffState, oscillator_neurons> oscillator;
  /// What each neuron of the oscillator showed the other in the step before; at first as in 6.2.2.1.
  std::array<std::int16_t, oscillator_neurons> acting{1, -1};
  std::array<neurons::TimedNeuron::State, children> pattern;

  bool operator==(const SplitGeneratorState&) const = default;
};

void fields(auto& archive, saving::Of<SplitGeneratorState> auto& state) {
  for (auto& neuron : state.oscillator) fields(archive, neuron);
  saving::wholes(archive, "acting", state.acting, -1, 1);
  for (auto& neuron : state.pattern) fields(archive, neuron);
}

/// One time step; wanted positions. Pure but for `state`.
ChildLevels step(const SplitGeneratorSteps& steps, SplitGeneratorState& state);

}  // namespace lamprey::science::networks
