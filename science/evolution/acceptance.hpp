#pragma once

#include "science/evolution/objective.hpp"

#include <cstdint>

namespace lamprey::science::evolution {

/// What is compared: every component of the error (8.3.2.1), or their sum.
enum class Criterion : std::uint8_t { per_component, total };

/// How the criterion calls a candidate against the last accepted state.
struct Comparison {
  bool acceptable = false;  ///< no error grows: neutral moves are kept (8.3.1 accumulates 0.512 + 0.488)
  bool better = false;      ///< acceptable, and an error shrinks: a success of eq. 8.1
};

Comparison compare(Criterion criterion, const Errors& candidate, const Errors& last_accepted);

/// 4.2.5: only what the criterion accepts, or occasionally a growing error besides.
enum class Acceptance : std::uint8_t { simple, annealing };

/// Eqs 3.6 and 4.2.5.1 with k_B = 1: whether a change ΔE of the summed error is accepted at this temperature:
/// ΔE ≤ 0, or exp(−ΔE/T) > r. Temperature ≥ 0 (0 accepts no growth); r uniform in [0, 1).
bool metropolis_accepts(double error_change, double temperature, double r);

}  // namespace lamprey::science::evolution
