#include "science/fitness/biped_fitness.hpp"

namespace lamprey::science::fitness {

Fitness score(const BipedCounts& counts, std::int32_t time_steps) {
  // 0.0 − x: without leg error the component is 0, not −0.
  return {.stability = 0.0 - 100.0 * counts.leg_error / time_steps,
          .distance = 100.0 * counts.distance / time_steps,
          .fuel = 0};
}

}  // namespace lamprey::science::fitness
