#include "science/networks/recurrent_eight.hpp"

#include "science/gaits/presets.hpp"
#include "tests/science/networks/output_text.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace lamprey::science::networks {
namespace {

using Rows = std::array<std::string, children>;

RecurrentEightSteps thesis_network(bool delay_refirings) {
  return whole_steps(gaits::recurrent_eight(gaits::Gait::walk_frames, delay_refirings));
}

/// N1 to N8, as the figures have them.
Rows by_number(const Rows& by_child) {
  Rows rows;
  for (std::size_t number = 1; number <= children; ++number) rows[number - 1] = by_child[child_of_neuron(number)];
  return rows;
}

TEST(RecurrentEight, LinksAreMutualAndThoseOfFigure715) {
  const std::array<std::string, children> links{"245", "136", "247", "138", "168", "257", "368", "457"};
  for (std::size_t number = 1; number <= children; ++number) {
    std::string text;
    for (const std::uint8_t input : input_children[child_of_neuron(number)]) {
      text += static_cast<char>('0' + children - input);
      const auto& back = input_children[input];
      EXPECT_EQ(std::ranges::count(back, child_of_neuron(number)), 1) << "N" << number;
    }
    std::ranges::sort(text);
    EXPECT_EQ(text, links[number - 1]) << "N" << number;
  }
}

TEST(RecurrentEight, TheInitialNetsAreThree) {
  const auto steps = thesis_network(false);
  for (std::size_t i = 0; i < children; ++i) EXPECT_EQ(net(steps, RecurrentEightState{}.outputs, i), 3);  // fig. 7.15
}

TEST(RecurrentEight, PutsOutFigure716CellByCell) {
  RecurrentEightState state;
  const Rows rows = by_number(output_text(thesis_network(false), state, 9));
  EXPECT_EQ(rows, (Rows{"0000+000-", "+0000000-", "0000+-+-+", "+-00+-+-+", "000000+0-", "00+00000-", "000000+-+",
                        "00+-00+-+"}));
}

TEST(RecurrentEight, HasTheNetsOfFigure716CellByCell) {
  // x: in a cycle, not calculated. Steps T2 to T9; those of T1 are the initial nets of fig. 7.15.
  const Rows figure{"xxxxxxxx", "xxxxxxxx", "xxxxx1x2", "x0n1x1x2", "xxxxxxxx", "xxxxxxxx", "xxxxxxx2", "xxx0n1x2"};
  const auto steps = thesis_network(false);
  RecurrentEightState state;
  step(steps, state);
  Rows nets;
  for (int t = 2; t <= 9; ++t) {
    for (std::size_t number = 1; number <= children; ++number) {
      const std::size_t i = child_of_neuron(number);
      const auto value = static_cast<int>(net(steps, state.outputs, i));
      const char digit = value < 0 ? 'n' : static_cast<char>('0' + value);
      nets[number - 1] += waits(steps.cycles, state.places, i) ? digit : 'x';
    }
    step(steps, state);
  }
  EXPECT_EQ(nets, figure);
}

TEST(RecurrentEight, DelaysRefiringsToWhereEquation710IsTakenByTheLetter) {
  // As fig. 7.16 up to T6. At T7 N3 and N8 fire again and now wait for their D1, of 4 and 2; N4, whose D1 is 0, does
  // not. At T9 nothing that N4 and N7 hear from has fired in T8.
  RecurrentEightState state;
  const Rows rows = by_number(output_text(thesis_network(true), state, 9));
  EXPECT_EQ(rows, (Rows{"0000+000-", "+0000000-", "0000+-000", "+-00+-+-0", "000000+0-", "00+00000-", "000000+-0",
                        "00+-0000+"}));
}

TEST(RecurrentEight, ANetOfZeroOrLessDoesNotFire) {
  RecurrentEightNetwork network;
  for (auto& neuron : network.neurons) neuron = {.times = {0, 1, 0, 1}, .weights = {1, 0, -1}};
  RecurrentEightState state;
  for (const auto& text : output_text(whole_steps(network), state, 6)) EXPECT_EQ(text, "000000");
  for (auto& neuron : network.neurons) neuron.weights = {0.2, 0.2, 0.2};
  state = {};
  for (const auto& text : output_text(whole_steps(network), state, 6)) EXPECT_EQ(text, "000000");
}

TEST(RecurrentEight, WeightsScaleTheInputsThatTheyBelongTo) {
  RecurrentEightNetwork network;
  network.neurons[2].weights = {0.5, -0.25, 0.125};
  ChildOutputs outputs{};
  outputs[input_children[2][0]] = 1;
  outputs[input_children[2][1]] = -1;
  outputs[input_children[2][2]] = -1;
  EXPECT_EQ(net(whole_steps(network), outputs, 2), 0.5 + 0.25 - 0.125);
}

}  // namespace
}  // namespace lamprey::science::networks
