#include "science/evolution/step_size.hpp"

#include <algorithm>
#include <cmath>

namespace lamprey::science::evolution {

double root_error_standard_deviation(double first_standard_deviation, double error) {
  return first_standard_deviation * std::sqrt(std::sqrt(error));
}

OneFifthState first_state(const OneFifthRule& rule) {
  return {.standard_deviation = rule.first_standard_deviation};
}

void record(const OneFifthRule& rule, OneFifthState& state, bool success) {
  ++state.tried;
  state.successes += success;
  if (state.tried < rule.window) return;

  // In whole numbers, so that 4 of 20 is exactly 1/5.
  const std::uint64_t share = std::uint64_t{5} * state.successes;
  double next = state.standard_deviation;
  if (share > state.tried) next = state.standard_deviation / rule.factor;
  if (share < state.tried) next = state.standard_deviation * rule.factor;
  next = std::max(next, rule.minimum_standard_deviation);
  next = std::min(next, rule.maximum_standard_deviation);
  state = {.standard_deviation = next};
}

}  // namespace lamprey::science::evolution
