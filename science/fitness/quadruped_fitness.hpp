#pragma once

#include "science/robots/quadruped.hpp"
#include "science/saving/archive.hpp"

#include <array>
#include <cstdint>

namespace lamprey::science::fitness {

/// The components of 7.3, per cent: S and D may be negative; F is within 0..100.
struct Fitness {
  double stability = 0;
  double distance = 0;
  double fuel = 0;

  bool operator==(const Fitness&) const = default;
};

/// Far beyond what any robot scores; what is read beyond it is refused, as it might end in no number.
inline constexpr double largest_component = 1e6;

void fields(auto& archive, saving::Of<Fitness> auto& fitness) {
  saving::real_within(archive, "stability", fitness.stability, -largest_component, largest_component);
  saving::real_within(archive, "distance", fitness.distance, -largest_component, largest_component);
  saving::real_within(archive, "fuel", fitness.fuel, -largest_component, largest_component);
}

/// R_S, R_D and R_F of eq. 7.4, each in 0..1: the environment that the robot is in (8.2.3).
struct Weights {
  double stability = 1;
  double distance = 1;
  double fuel = 1;
};

/// Eq. 7.4: R_S·S + R_D·D + R_F·F, summed from left to right.
inline double total(const Fitness& fitness, const Weights& weights) {
  return weights.stability * fitness.stability + weights.distance * fitness.distance + weights.fuel * fitness.fuel;
}

/// F_I of eq. 7.9, in units of fuel.
inline constexpr int initial_fuel = 1000;

/// How hard a push on the ground drives the body; rough terrain (1.2, robots::Terrain) lowers it.
inline constexpr double flat_push_factor = 1;

/// What happened in the steps of one evaluation. A value that starts at zero.
struct QuadrupedCounts {
  std::array<std::int32_t, robots::supports> steps_with_support{};  ///< by robots::Support
  std::int32_t inclined_steps = 0;                                  ///< L_E of eq. 7.5
  std::int32_t front_pushes = 0;                                    ///< D_FL of eq. 7.7
  std::int32_t back_pushes = 0;  ///< D_BL of eq. 7.7 is twice this: back legs are power legs
  std::int32_t drags = 0;        ///< D_E of eq. 7.7
  std::int32_t brushing_steps = 0;
  std::int32_t limit_steps = 0;
  std::int32_t moving_steps = 0;

  bool operator==(const QuadrupedCounts&) const = default;
};

inline void count(QuadrupedCounts& counts, const robots::QuadrupedStep& step) {
  ++counts.steps_with_support[static_cast<std::size_t>(robots::support(step.feet_on_ground))];
  counts.inclined_steps += step.inclined;
  counts.front_pushes += step.front_pushes;
  counts.back_pushes += step.back_pushes;
  counts.drags += step.drags;
  counts.brushing_steps += step.drags > 0;
  counts.limit_steps += step.limit_pushed;
  counts.moving_steps += step.moved;
}

/// Units of fuel used, by the table under eq. 7.9: a step pays each row at most once. Rows 4 to 6 have exactly the pair
/// on the ground, as eq. 7.6 does. Row 6's formula takes two units and its text says five: the formula holds.
std::int32_t fuel_used(const QuadrupedCounts& counts);

/// Eqs 7.5, 7.7 and 7.9 after `time_steps` ≥ 1 steps; the push factor scales D_FL and D_BL, not D_E. Fuel never falls
/// below 0.
Fitness score(const QuadrupedCounts& counts, std::int32_t time_steps, double push_factor = flat_push_factor);

}  // namespace lamprey::science::fitness
