#include "science/networks/timed_loop.hpp"

namespace lamprey::science::networks {

TimedLoopSteps whole_steps(const TimedLoop& loop) {
  TimedLoopSteps steps{};
  // Times are never negative, so conversion rounds down.
  const auto whole = [](double time) { return static_cast<std::int16_t>(time); };
  for (std::size_t i = 0; i < children; ++i) {
    const LoopTimes& times = loop.servo_times[i];
    steps.forward_opens[i] = whole(times[forward_at]);
    steps.forward_closes[i] = static_cast<std::int16_t>(steps.forward_opens[i] + whole(times[forward_for]));
    steps.backward_opens[i] = whole(times[backward_at]);
    steps.backward_closes[i] = static_cast<std::int16_t>(steps.backward_opens[i] + whole(times[backward_for]));
  }
  steps.period = static_cast<std::int16_t>(loop.period);
  return steps;
}

}  // namespace lamprey::science::networks
