#pragma once

#include <cstdint>

namespace lamprey::science::gaits {

/// The quadruped's gaits (7.4.4, appendix D). walk_frames is not one to walk by: the nine steps of fig. 7.13, in which
/// the thesis compares outputs of networks with what was wanted.
enum class Gait : std::uint8_t { walk, trot, pace, gallop, pronk, walk_frames };

}  // namespace lamprey::science::gaits
