#pragma once

#include "science/networks/four_mother.hpp"

namespace lamprey::science::gaits {

/// The walk of figs 7.5, 7.12 and 7.13 on the four-mother network. One period is 100 time steps: back left, front left,
/// back right and front right in turn lift and swing for ten steps and land for ten; all rest for ten; then all push
/// back together for ten. One period from standing scores S = 80, D = 60, F = 83 exactly.
networks::FourMotherNetwork walk();

}  // namespace lamprey::science::gaits
