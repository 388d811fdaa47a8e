#include "science/gaits/two_beat.hpp"

#include <stdexcept>

namespace lamprey::science::gaits {

std::array<bool, robots::legs> second_group(Gait gait) {
  // Front left, front right, back left, back right.
  switch (gait) {
    case Gait::trot:
      return {false, true, true, false};
    case Gait::pace:
      return {false, true, false, true};
    case Gait::gallop:
      return {false, false, true, true};
    case Gait::pronk:
      return {false, false, false, false};
    case Gait::walk:
    case Gait::walk_frames:
      break;
  }
  throw std::invalid_argument("the gait moves four legs in turn, not in two groups");
}

}  // namespace lamprey::science::gaits
