#pragma once

#include "science/evolution/mutation.hpp"
#include "science/random/stream.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace lamprey::science::evolution {

/// How a gait is taken out of equilibrium before it evolves (8.2.1, 8.2.2).
struct Disturbance {
  int size = 0;                ///< each time of a disturbed unit changes by a whole number in ±size
  std::uint32_t per_kind = 0;  ///< 0..4 units of each kind: as many vertical as horizontal ones (8.2.2)
};

/// The number of each kind that is a share of `percent` of eight units, fractions dropped: 25 % are one and one.
constexpr std::uint32_t disturbed_per_kind(std::int64_t percent) {
  return static_cast<std::uint32_t>(4 * percent / 100);
}

/// The two kinds of units, vertical and horizontal, of which equally many are disturbed.
using UnitKinds = std::array<std::array<std::uint8_t, 4>, 2>;

/// Disturbs `units` and holds the genes within the plan's bounds. Of each kind, units are chosen without replacement by
/// a partial Fisher–Yates shuffle: draw i swaps place i with place i + bounded(word i, 4 − i), by the words of block
/// (0, disturbance_selection, kind). Gene g of unit u moves by word g of block (0, disturbance, u).
void disturb(const random::Stream& stream, const Disturbance& disturbance, const UnitKinds& kinds, const GenePlan& plan,
             std::span<Unit> units);

}  // namespace lamprey::science::evolution
