#include "science/networks/cycle.hpp"

namespace lamprey::science::networks {

CycleSteps whole_steps(const std::array<ChildTimes, children>& times) {
  // Times are never negative, so conversion rounds down; the longest cycle has 400 steps.
  const auto later = [](std::int16_t start, double time) {
    return static_cast<std::int16_t>(start + static_cast<std::int16_t>(time));
  };
  CycleSteps steps{};
  for (std::size_t i = 0; i < children; ++i) {
    steps.on_opens[i] = later(0, times[i][delay_before_on]);
    steps.on_closes[i] = later(steps.on_opens[i], times[i][on_time]);
    steps.off_opens[i] = later(steps.on_closes[i], times[i][delay_before_off]);
    steps.ends[i] = later(steps.off_opens[i], times[i][off_time]);
  }
  return steps;
}

}  // namespace lamprey::science::networks
