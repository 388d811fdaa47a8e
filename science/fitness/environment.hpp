#pragma once

#include "science/fitness/quadruped_fitness.hpp"
#include "science/robots/terrain.hpp"

namespace lamprey::science::fitness {

/// What a robot is in: how much each component of its fitness counts (8.2.3), and the ground (1.2). May change in a
/// run.
struct Environment {
  Weights weights;
  robots::Terrain terrain;
};

}  // namespace lamprey::science::fitness
