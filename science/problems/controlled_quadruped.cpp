#include "science/problems/controlled_quadruped.hpp"

namespace lamprey::science::problems {

std::vector<std::string> servo_names() {
  std::vector<std::string> names(robots::servos);
  for (std::size_t leg = 0; leg < robots::legs; ++leg) {
    const std::string name =
        std::string(robots::is_front(leg) ? "front " : "back ") + (leg % 2 == 0 ? "left " : "right ");
    names[robots::vertical_servo(leg)] = name + "vertical";
    names[robots::horizontal_servo(leg)] = name + "horizontal";
  }
  return names;
}

double body_advance(const robots::Quadruped& before, const robots::Quadruped& after, const robots::QuadrupedStep& step,
                    const robots::Terrain& terrain) {
  constexpr std::int16_t first_pushing_position = 10;
  constexpr std::int16_t last_pushing_position = 20;
  for (std::size_t leg = 0; leg < robots::legs; ++leg) {
    const std::size_t servo = robots::horizontal_servo(leg);
    const std::int16_t from = before.position[servo];
    const std::int16_t to = after.position[servo];
    const bool on_ground = (step.feet_on_ground >> leg & 1U) != 0;
    if (on_ground && to < from && to >= first_pushing_position && from <= last_pushing_position) {
      return terrain.push_factor * (from - to);
    }
  }
  return 0;
}

}  // namespace lamprey::science::problems
