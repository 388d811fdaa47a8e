#include "science/evolution/rtea.hpp"

namespace lamprey::science::evolution {

StepDistribution step_distribution(const Rtea& rtea, const OneFifthState& one_fifth, const Errors& last_accepted) {
  using enum StepDistribution::Kind;
  if (rtea.steps == Steps::uniform) return {.kind = uniform, .size = rtea.size};
  if (rtea.steps == Steps::one_fifth_rule) return {.kind = normal, .standard_deviation = one_fifth.standard_deviation};

  const double half_size = rtea.size / 2.0;
  // Under `maximise` there is no error to take a root of.
  const bool follows_error = rtea.step_variance == StepVariance::root_error && rtea.objective == Objective::target;
  return {
      .kind = normal,
      .standard_deviation = follows_error ? root_error_standard_deviation(half_size, total(last_accepted)) : half_size};
}

}  // namespace lamprey::science::evolution
