#pragma once

#include "science/fitness/quadruped_fitness.hpp"
#include "science/networks/four_mother.hpp"
#include "science/robots/quadruped.hpp"

#include <cstdint>
#include <span>

namespace lamprey::science::fitness {

/// The quadruped under a four-mother network: what a trainer tunes and how it is tried. Immutable; any thread.
struct QuadrupedTrial {
  using Genome = networks::FourMotherNetwork;

  /// All that lives on from one evaluation to the next where the robot walks on.
  struct Body {
    robots::Quadruped robot = robots::standing();
    networks::FourMotherState network;

    bool operator==(const Body&) const = default;
  };

  std::int32_t time_steps = 100;  ///< T, at least 1; settled by the published 139.375 (docs/decisions)

  /// One evaluation: T steps from where `body` is, which is left where it ends. Counts and fuel start anew.
  Fitness evaluate(const Genome& network, Body& body) const;

  /// The genes that evolve, a unit per child neuron; the mothers are not among them (7.4.4).
  static std::span<networks::ChildTimes> units(Genome& network) { return network.child_times; }
  /// Units that mutate-some changes together (4.2.2).
  static constexpr auto& symmetric_units = networks::children_of_leg_pairs;
  static constexpr double minimum_gene = networks::minimum_time;
  static constexpr double maximum_gene = networks::maximum_time;
};

}  // namespace lamprey::science::fitness
