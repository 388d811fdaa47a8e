#pragma once

#include <string>
#include <vector>

namespace lamprey::science::robots {

/// What a controller and its robot did, step by step: for plots and for looking (figs 7.26, appendix D).
struct Recording {
  std::vector<std::string> servos;             ///< names: "front left vertical", "leg 1"; n of them
  std::vector<std::vector<double>> outputs;    ///< per step, n: what the controller put out for each servo
  std::vector<std::vector<double>> positions;  ///< before the first step and after each: steps + 1 rows of n
  std::vector<double> distance;                ///< after each step: how far the body has come, in positions of a leg
  std::vector<unsigned> feet_on_ground;        ///< per step: bit `leg` is set if that foot was on the ground
};

}  // namespace lamprey::science::robots
