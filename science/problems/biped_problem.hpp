#pragma once

#include "science/actuators/actuator.hpp"
#include "science/evolution/problem.hpp"

#include <cstdint>
#include <memory>

namespace lamprey::science::problems {

/// How the two neurons are connected: figs 6.11 and 6.18.
enum class BipedNetwork : std::uint8_t { recurrent_pair, feed_forward_pair };

/// Eq. 6.3; 6.2.2.2; eq. 6.5; 2.6.1; McMinn's of 2.6.1 and 6.2.2.
enum class BipedNeuron : std::uint8_t { threshold, acting_output, net_as_on_time, mcculloch_pitts, timed };

/// Which weights evolve. as_printed: 0 to 1 (6.2.2.4), ±10 for net_as_on_time (eq. 6.5). either_sign: the first range
/// is −1 to 1. No network with weights of 0 to 1 generates the antiphase; all worked examples of 6.2.2 have negative
/// ones.
enum class BipedWeights : std::uint8_t { as_printed, either_sign };

struct BipedSettings {
  BipedNetwork network = BipedNetwork::recurrent_pair;
  BipedNeuron neuron = BipedNeuron::threshold;
  BipedWeights weights = BipedWeights::as_printed;
  actuators::Actuator actuator;
  std::int32_t time_steps = 40;  ///< T of eq. 6.4 (6.2.2.4), at least 1
};

/// What the chain holds both legs at when a neuron puts out 0: the middle of the walking range. With the default stroke
/// an unending +1 or −1 brings a leg to either end of it.
inline constexpr std::int16_t biped_standing_position = 15;

/// The biped under a network of two neurons, N1 on leg 1 and N2 on leg 2, as 6.2.2.4 tries it. The thesis has no
/// parameters to start with, so there is no preset. Only the weights of distance and stability matter of the
/// environment, and not to the fitness itself. Throws std::invalid_argument for a time_steps below 1.
std::unique_ptr<evolution::Problem> make_biped_problem(const BipedSettings& settings);

}  // namespace lamprey::science::problems
