#pragma once

#include <array>
#include <cstdint>

namespace lamprey::science::robots {

/// The ground under a quadruped (1.2, 9.4). Flat ground is the default.
struct Terrain {
  /// How hard a push drives the body, 0..1: scales D_FL and D_BL of eq. 7.7.
  double push_factor = 1;
  /// Vertical position at which each foot is on the ground, 0..30, by leg: eq. 7.1 has 10.
  std::array<std::int16_t, 4> ground_level{10, 10, 10, 10};

  bool operator==(const Terrain&) const = default;
};

}  // namespace lamprey::science::robots
