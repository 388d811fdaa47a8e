#include "science/networks/tonic.hpp"

#include "science/maths/elementary.hpp"

#include <algorithm>

namespace lamprey::science::networks {

std::optional<TonicGait> gait_of(const Tonic& tonic) {
  const auto row = std::find(table_of_tonics.begin(), table_of_tonics.end(), tonic);
  if (row == table_of_tonics.end()) return std::nullopt;
  return static_cast<TonicGait>(row - table_of_tonics.begin() + 1);
}

TonicSteps whole_steps(const TonicNetwork& network) {
  // The input of a child that acts is always +1.
  const auto position = [](double net) { return position_of_output(1 + 1 / (1 + maths::exponential(-net))); };
  TonicSteps steps{};
  steps.tonic = network.tonic;
  for (std::size_t mother = 0; mother < tonic_mothers; ++mother) {
    steps.activated[mother] = position(network.weights[mother]);
    steps.reversed[mother] = position(-network.weights[mother]);
  }
  return steps;
}

ChildLevels step(const TonicSteps& steps, TonicState& state) {
  if (state.step_of_swing % steps_per_shift == 0) {
    const auto places = static_cast<std::size_t>(places_clockwise(state.step_of_swing / steps_per_shift));
    for (std::size_t mother = 0; mother < tonic_mothers; ++mother) {
      const std::int16_t pulse = steps.tonic[(mother + tonic_mothers - places) % tonic_mothers];
      if (pulse > 0) {
        state.positions[mother] = state.previous[mother] < 0 ? steps.activated[mother] : steps.reversed[mother];
      }
      state.previous[mother] = pulse;
    }
  }
  state.step_of_swing = (state.step_of_swing + 1) % (shifts_per_swing * steps_per_shift);

  ChildLevels levels;
  levels.fill(position_of_output(resting_output));
  for (std::size_t mother = 0; mother < tonic_mothers; ++mother) {
    levels[horizontal_child_of_tonic_mother[mother]] = state.positions[mother];
  }
  return levels;
}

}  // namespace lamprey::science::networks
