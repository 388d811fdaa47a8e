#include "science/fitness/quadruped_fitness.hpp"

#include <algorithm>

namespace lamprey::science::fitness {

namespace {

std::int32_t steps_with(const QuadrupedCounts& counts, robots::Support support) {
  return counts.steps_with_support[static_cast<std::size_t>(support)];
}

}  // namespace

std::int32_t fuel_used(const QuadrupedCounts& counts) {
  using enum robots::Support;
  return 10 * counts.limit_steps +                     // row 1
         8 * steps_with(counts, none) +                // row 2
         6 * steps_with(counts, one) +                 // row 3
         5 * steps_with(counts, side_pair) +           // row 4
         3 * steps_with(counts, front_or_back_pair) +  // row 5
         2 * steps_with(counts, diagonal_pair) +       // row 6
         2 * counts.brushing_steps +                   // row 7
         1 * steps_with(counts, three) +               // row 8
         1 * counts.moving_steps;                      // row 9
}

Fitness score(const QuadrupedCounts& counts, std::int32_t time_steps, double push_factor) {
  using enum robots::Support;
  const std::int32_t supported = steps_with(counts, three) + steps_with(counts, diagonal_pair) +
                                 steps_with(counts, side_pair) + steps_with(counts, front_or_back_pair);
  const std::int32_t stability = supported - counts.inclined_steps;
  const double driven = push_factor * (counts.front_pushes + 2 * counts.back_pushes);
  const double distance = driven - counts.drags;
  const std::int32_t fuel_left = std::max(0, initial_fuel - fuel_used(counts));
  return {.stability = 100.0 * stability / time_steps,
          .distance = 100.0 * distance / time_steps,
          .fuel = 100.0 * fuel_left / initial_fuel};
}

}  // namespace lamprey::science::fitness
