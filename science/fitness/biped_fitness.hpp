#pragma once

#include "science/fitness/quadruped_fitness.hpp"
#include "science/robots/biped.hpp"

#include <cstdint>

namespace lamprey::science::fitness {

/// What happened in the steps of one evaluation. A value that starts at zero.
struct BipedCounts {
  std::int32_t distance = 0;   ///< positions
  std::int32_t leg_error = 0;  ///< legs × steps

  bool operator==(const BipedCounts&) const = default;
};

inline void count(BipedCounts& counts, const robots::BipedStep& step) {
  counts.distance += step.advance;
  counts.leg_error += step.leg_error;
}

/// Eq. 6.4 after `time_steps` ≥ 1 steps, in the components of the quadruped's fitness so that one trainer serves both:
/// distance is 100·distance/T, stability −100·leg error/T, and there is no fuel. With weights of 1 the total is f.
Fitness score(const BipedCounts& counts, std::int32_t time_steps);

/// Perfect antiphase of ten steps (6.2.1): in each step one leg pushes the body by one position while the other swings
/// back, and neither leaves 10..20. Distance is T and leg error 0 whatever T is, so f = 100.
inline constexpr Fitness perfect_antiphase{.stability = 0, .distance = 100, .fuel = 0};

}  // namespace lamprey::science::fitness
