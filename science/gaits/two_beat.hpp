#pragma once

#include "science/gaits/gait.hpp"
#include "science/robots/quadruped.hpp"

#include <array>

namespace lamprey::science::gaits {

// Trot, pace, gallop and pronk (7.4.4, appendix D; their parameters' pictures are lost). The legs move in at most two
// groups, one after the other.

/// Whether each leg, by robots::Leg, moves with the second group. Trot: front left and back right, then the others;
/// pace: left, then right; gallop: front, then back; pronk: all at once. Throws std::invalid_argument for a gait that
/// isn't one of these.
std::array<bool, robots::legs> second_group(Gait gait);

}  // namespace lamprey::science::gaits
