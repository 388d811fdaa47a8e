#include "science/fitness/quadruped_trial.hpp"

namespace lamprey::science::fitness {

Fitness QuadrupedTrial::evaluate(const Genome& network, Body& body) const {
  const networks::FourMotherSteps steps = networks::whole_steps(network);
  Body now = body;  // a copy keeps the state out of reach of aliasing, and so in registers
  QuadrupedCounts counts;
  for (std::int32_t t = 0; t < time_steps; ++t) {
    // A child drives the servo of its own number.
    const robots::ServoCommands commands = networks::step(steps, now.network);
    count(counts, robots::step(now.robot, commands));
  }
  body = now;
  return score(counts, time_steps);
}

}  // namespace lamprey::science::fitness
