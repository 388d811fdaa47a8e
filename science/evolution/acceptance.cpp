#include "science/evolution/acceptance.hpp"

#include "science/maths/elementary.hpp"

namespace lamprey::science::evolution {

Comparison compare(Criterion criterion, const Errors& candidate, const Errors& last_accepted) {
  if (criterion == Criterion::total) {
    const double now = total(candidate);
    const double before = total(last_accepted);
    return {.acceptable = now <= before, .better = now < before};
  }
  const bool none_grows = candidate.stability <= last_accepted.stability &&
                          candidate.distance <= last_accepted.distance && candidate.fuel <= last_accepted.fuel;
  const bool one_shrinks = candidate.stability < last_accepted.stability ||
                           candidate.distance < last_accepted.distance || candidate.fuel < last_accepted.fuel;
  return {.acceptable = none_grows, .better = none_grows && one_shrinks};
}

bool metropolis_accepts(double error_change, double temperature, double r) {
  return error_change <= 0 || maths::exponential(-error_change / temperature) > r;
}

}  // namespace lamprey::science::evolution
