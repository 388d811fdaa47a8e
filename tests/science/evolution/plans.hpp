#pragma once

#include "science/evolution/gene_plan.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lamprey::science::evolution {

using Unit = std::array<double, 4>;
using Units = std::array<Unit, 8>;

/// Eight units of four genes, two kinds and six symmetric sets, as the quadruped's networks have them.
inline GenePlan eight_units(double minimum, double maximum) {
  GenePlan plan;
  plan.genes.assign(32, {.minimum = minimum, .maximum = maximum});
  for (std::uint32_t unit = 0; unit < 8; ++unit) {
    plan.units.push_back({4 * unit, 4 * unit + 1, 4 * unit + 2, 4 * unit + 3});
  }
  plan.kinds = {{0, 1, 4, 5}, {2, 3, 6, 7}};
  plan.symmetric_units = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 2, 4, 6}, {1, 3, 5, 7}, {0, 2, 5, 7}, {1, 3, 4, 6}};
  return plan;
}

inline Units units_of(std::span<const double> genes) {
  Units units;
  for (std::size_t unit = 0; unit < units.size(); ++unit) {
    for (std::size_t gene = 0; gene < 4; ++gene) units[unit][gene] = genes[4 * unit + gene];
  }
  return units;
}

}  // namespace lamprey::science::evolution
