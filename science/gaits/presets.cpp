#include "science/gaits/presets.hpp"

#include "science/gaits/two_beat.hpp"
#include "science/gaits/walk.hpp"
#include "science/robots/quadruped.hpp"

#include <array>
#include <cstddef>
#include <stdexcept>

namespace lamprey::science::gaits {

namespace {

using namespace networks;  // NOLINT(google-build-using-namespace): names of neurons only

// The two-beat gaits, in time steps.
constexpr double period = 25;
constexpr double lift = 4;
constexpr double swing = 2 * lift;  // and land

/// Fig. 7.13(a), in frames of the gait, by the numbers N1 to N8.
constexpr std::array<ChildTimes, children> figure_7_13{
    {{4, 1, 3, 1}, {0, 1, 7, 1}, {4, 1, 0, 1}, {0, 1, 0, 1}, {6, 1, 1, 1}, {2, 1, 5, 1}, {6, 1, 0, 1}, {2, 1, 0, 1}}};

FourMotherNetwork two_beat(Gait gait) {
  const auto second = second_group(gait);
  FourMotherNetwork network;
  // The verticals' falling edge lets the first group's feet down; the horizontals' comes when the first group has
  // landed.
  network.mother_times[front_vertical] = network.mother_times[back_vertical] = {.on = lift, .off = period - lift};
  network.mother_times[front_horizontal] = network.mother_times[back_horizontal] = {.on = swing, .off = period - swing};
  for (std::size_t leg = 0; leg < robots::legs; ++leg) {
    const double start = second[leg] ? swing : 0;
    network.child_times[robots::vertical_servo(leg)] = {start, lift, start, lift};
    // Both groups push when the second has landed.
    network.child_times[robots::horizontal_servo(leg)] = {start, swing, swing, swing};
  }
  return network;
}

OneMotherNetwork figure_7_13_times(double frame, double trigger_period) {
  OneMotherNetwork network{.trigger_period = trigger_period};
  for (std::size_t number = 1; number <= children; ++number) {
    for (std::size_t time = 0; time < figure_7_13[0].size(); ++time) {
      network.child_times[child_of_neuron(number)][time] = frame * figure_7_13[number - 1][time];
    }
  }
  return network;
}

TonicGait tonic_gait(Gait gait) {
  switch (gait) {
    case Gait::walk:
      return TonicGait::walk;
    case Gait::gallop:
      return TonicGait::gallop;
    case Gait::trot:
      return TonicGait::trot;
    case Gait::pace:
      return TonicGait::pace;
    case Gait::pronk:
    case Gait::walk_frames:
      break;
  }
  throw std::invalid_argument("the table of tonics has no row for this gait");
}

}  // namespace

FourMotherNetwork four_mother(Gait gait) {
  return gait == Gait::walk ? walk() : two_beat(gait);
}

OneMotherNetwork one_mother(Gait gait) {
  if (gait == Gait::walk_frames) return figure_7_13_times(1, 9);
  if (gait == Gait::walk) return figure_7_13_times(10, 100);
  const TimedLoop loop = timed_loop(gait);
  OneMotherNetwork network{.trigger_period = static_cast<double>(loop.period)};
  for (std::size_t i = 0; i < children; ++i) {
    const LoopTimes& times = loop.servo_times[i];
    const double forward_ends = times[forward_at] + times[forward_for];
    network.child_times[i] = {times[forward_at], times[forward_for], times[backward_at] - forward_ends,
                              times[backward_for]};
  }
  return network;
}

RecurrentEightNetwork recurrent_eight(Gait gait, bool delay_refirings) {
  if (gait != Gait::walk && gait != Gait::walk_frames) {
    throw std::invalid_argument("the recurrent network has weights for the walk only");
  }
  const OneMotherNetwork timed = one_mother(gait);
  RecurrentEightNetwork network{.delay_refirings = delay_refirings};
  for (std::size_t i = 0; i < children; ++i) {
    network.neurons[i].times = timed.child_times[i];
    network.neurons[i].weights.fill(-1);
  }
  return network;
}

TimedLoop timed_loop(Gait gait) {
  const FourMotherNetwork network = four_mother(gait);
  TimedLoop loop;
  for (std::size_t i = 0; i < children; ++i) {
    const MotherTimes& mother = network.mother_times[i / 2];
    const ChildTimes& times = network.child_times[i];
    loop.servo_times[i] = {times[delay_before_on], times[on_time], mother.on + times[delay_before_off],
                           times[off_time]};
    loop.period = static_cast<std::int32_t>(mother.on + mother.off);
  }
  return loop;
}

SplitGenerator split_generator(Gait gait) {
  constexpr double half_period = 10;
  const auto second = second_group(gait);
  SplitGenerator network{.oscillator_on_time = half_period, .oscillator_off_time = half_period};
  for (std::size_t leg = 0; leg < robots::legs; ++leg) {
    PatternNeuron neuron{.threshold = 0.5};
    neuron.weights[second[leg] ? 1 : 0] = 1;
    neuron.time = lift;
    network.pattern[robots::vertical_servo(leg)] = neuron;
    neuron.time = swing;
    network.pattern[robots::horizontal_servo(leg)] = neuron;
  }
  return network;
}

TonicNetwork tonic(Gait gait) {
  return {.tonic = tonic_of(tonic_gait(gait)), .weights = {2.5, 2.5, 2.5, 2.5}};
}

}  // namespace lamprey::science::gaits
