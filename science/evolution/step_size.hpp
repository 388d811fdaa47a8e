#pragma once

#include "science/saving/archive.hpp"

#include <algorithm>
#include <cstdint>

namespace lamprey::science::evolution {

/// The largest range of a change is ten time steps (8.2.1); of it, `percent` with fractions dropped: 25 % are 2.
constexpr int size_of_percent(std::int64_t percent) {
  return static_cast<int>(percent / 10);
}

/// How a normal step's standard deviation follows the error: not at all, or by variance σ0²·√error (3.6).
enum class StepVariance : std::uint8_t { constant, root_error };

/// σ0·√√error, the root of that variance. `error` ≥ 0: the summed weighted error of the last accepted state.
double root_error_standard_deviation(double first_standard_deviation, double error);

/// Rechenberg's 1/5 success rule (3.6, 4.2.4). The thesis gives no window, factor or bounds: they are parameters.
struct OneFifthRule {
  double first_standard_deviation = 5;
  std::uint32_t window = 20;  ///< cycles, at least 1; windows don't overlap
  double factor = 0.85;       ///< in (0, 1]: the standard deviation is multiplied by it, or divided
  double minimum_standard_deviation = 0.3;
  double maximum_standard_deviation = 10;
};

/// The rule's state between two cycles.
struct OneFifthState {
  double standard_deviation = 0;
  std::uint32_t tried = 0;      ///< cycles of the present window
  std::uint32_t successes = 0;  ///< of those

  bool operator==(const OneFifthState&) const = default;
};

void fields(auto& archive, const OneFifthRule& rule, saving::Of<OneFifthState> auto& state) {
  saving::real_within(archive, "standard_deviation", state.standard_deviation, 0,
                      std::max(rule.first_standard_deviation, rule.maximum_standard_deviation));
  archive.whole("tried", state.tried, 0, rule.window - 1);
  archive.whole("successes", state.successes, 0, state.tried);
}

/// The first standard deviation, even where it is out of bounds: they hold for what the rule sets.
OneFifthState first_state(const OneFifthRule& rule);

/// Counts one cycle; at a window's end, a share of successes above 1/5 enlarges the standard deviation, one below 1/5
/// reduces it, one of exactly 1/5 leaves it.
void record(const OneFifthRule& rule, OneFifthState& state, bool success);

}  // namespace lamprey::science::evolution
