#pragma once

#include "science/actuators/actuator.hpp"
#include "science/evolution/problem.hpp"
#include "science/gaits/gait.hpp"
#include "science/robots/machine.hpp"

#include <cstdint>
#include <memory>

namespace lamprey::science::problems {

/// What moves the quadruped: figs 7.23, 7.21, 7.14, 2.7, 9.1 and the loop without any network of 9.2.
enum class QuadrupedNetwork : std::uint8_t {
  four_mother,
  one_mother,
  recurrent_eight,
  split_generator,
  tonic,
  timed_loop
};

/// What of the tonic network of 9.3 a trainer tunes: the input tonic as in 9.4, or besides the weights that it asks
/// for.
enum class TonicGenes : std::uint8_t { tonic, tonic_and_weights };

struct QuadrupedSettings {
  QuadrupedNetwork network = QuadrupedNetwork::four_mother;
  gaits::Gait gait = gaits::Gait::walk;
  actuators::Actuator actuator;                ///< of every servo; gait walk_frames has no use of it
  std::int32_t time_steps = 100;               ///< T, at least 1; settled by the published 139.375 (docs/decisions)
  bool delay_refirings = true;                 ///< recurrent_eight only: whether D1 delays re-firings too
  TonicGenes tonic_genes = TonicGenes::tonic;  ///< tonic only
  robots::Machine* machine = nullptr;          ///< evaluated on in the simulation's place; outlives the problem
};

/// Whether the network has a preset of the gait: four_mother and timed_loop of all but walk_frames, one_mother of all,
/// recurrent_eight of walk and walk_frames, split_generator of the two-beat gaits, tonic of the four of 9.3's table.
bool has_preset(QuadrupedNetwork network, gaits::Gait gait);

/// The quadruped under a network, preset to a gait, which is what `target` aims at: expected() is what the four-mother
/// preset of that gait scores, simulated, with the same actuator and time_steps. Gait walk_frames has no robot: its
/// stability is how far the outputs agree with those of fig. 7.13(b), per cent (output_agreement.hpp). Genes come unit
/// by unit, a unit of genes per child in the order of networks::child, for each network:
///   four_mother      D1, T_ON, D2, T_OFF; the mothers are not tuned (7.4.4)
///   one_mother       the same; a ninth unit is T_D
///   recurrent_eight  the same and three weights, by networks::input_children
///   timed_loop       forward at, for; backward at, for
///   split_generator  threshold, time and two weights; a ninth unit is the oscillator's T_ON and T_OFF
///   tonic            not by child but by mother, clockwise from the right front: the input, and its weight if tuned
/// Throws std::invalid_argument for a gait without a preset, or a time_steps below 1.
std::unique_ptr<evolution::Problem> make_quadruped_problem(const QuadrupedSettings& settings);

}  // namespace lamprey::science::problems
