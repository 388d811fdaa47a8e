#pragma once

#include "science/fitness/quadruped_fitness.hpp"

#include <cmath>
#include <cstdint>

namespace lamprey::science::evolution {

/// What the trainer wants. `target`: the expected fitness, that of the undisturbed gait (8.2.3). `maximise`: as much of
/// eq. 7.4 as there is. Under `target` the weights only scale the errors.
enum class Objective : std::uint8_t { target, maximise };

/// Weighted error of each component; under `maximise` it is negative where the fitness is positive.
struct Errors {
  double stability = 0;
  double distance = 0;
  double fuel = 0;
};

/// The summed error, from left to right.
inline double total(const Errors& errors) {
  return errors.stability + errors.distance + errors.fuel;
}

/// `target`: R·|expected − value|; `maximise`: −R·value, for each component.
inline Errors errors(Objective objective, const fitness::Weights& weights, const fitness::Fitness& expected,
                     const fitness::Fitness& value) {
  const auto error = [objective](double weight, double wanted, double got) {
    return objective == Objective::target ? weight * std::fabs(wanted - got) : -(weight * got);
  };
  return {.stability = error(weights.stability, expected.stability, value.stability),
          .distance = error(weights.distance, expected.distance, value.distance),
          .fuel = error(weights.fuel, expected.fuel, value.fuel)};
}

}  // namespace lamprey::science::evolution
