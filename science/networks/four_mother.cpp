#include "science/networks/four_mother.hpp"

namespace lamprey::science::networks {

FourMotherSteps whole_steps(const FourMotherNetwork& network) {
  FourMotherSteps steps{};
  for (std::size_t mother = 0; mother < mothers; ++mother) {
    const MotherTimes& times = network.mother_times[mother];
    // Times are never negative, so conversion rounds down.
    steps.mother_on[mother] = static_cast<std::int32_t>(times.on);
    steps.mother_period[mother] = steps.mother_on[mother] + static_cast<std::int32_t>(times.off);
    steps.linked[mother] = times.linked;
  }
  for (std::size_t i = 0; i < children; ++i) {
    const ChildTimes& times = network.child_times[i];
    steps.on_opens[i] = static_cast<std::int16_t>(times[delay_before_on]);
    steps.on_closes[i] = static_cast<std::int16_t>(steps.on_opens[i] + static_cast<std::int16_t>(times[on_time]));
    steps.off_opens[i] = static_cast<std::int16_t>(times[delay_before_off]);
    steps.off_closes[i] = static_cast<std::int16_t>(steps.off_opens[i] + static_cast<std::int16_t>(times[off_time]));
  }
  return steps;
}

}  // namespace lamprey::science::networks
