#include "science/gaits/walk.hpp"

namespace lamprey::science::gaits {

namespace {

constexpr double unit = 10;  // fig. 7.12: a unit of the gait is ten time steps
constexpr double period = 100;

}  // namespace

networks::FourMotherNetwork walk() {
  using namespace networks;  // NOLINT(google-build-using-namespace): names of neurons only

  FourMotherNetwork network;
  // The verticals' falling edge lets a lifted foot down; the horizontals' starts the common push.
  network.mother_times[front_vertical] = network.mother_times[back_vertical] = {.on = unit, .off = period - unit};
  network.mother_times[front_horizontal] = network.mother_times[back_horizontal] = {.on = period - unit, .off = unit};

  const auto set_leg = [&network](Mother vertical, Mother horizontal, Side side, int slot) {
    const double start = 2 * unit * slot;
    network.child_times[child(vertical, side)] = {start, unit, start, unit};
    network.child_times[child(horizontal, side)] = {start, unit, 0, unit};
  };
  // 7.4.1 and fig. 7.12: back left swings first.
  set_leg(back_vertical, back_horizontal, left, 0);
  set_leg(front_vertical, front_horizontal, left, 1);
  set_leg(back_vertical, back_horizontal, right, 2);
  set_leg(front_vertical, front_horizontal, right, 3);
  return network;
}

}  // namespace lamprey::science::gaits
