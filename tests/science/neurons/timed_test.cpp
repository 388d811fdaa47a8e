#include "science/neurons/timed.hpp"

#include <gtest/gtest.h>
#include <initializer_list>
#include <string>

namespace lamprey::science::neurons {
namespace {

/// Outputs over a row of nets, as + and 0.
std::string outputs(const TimedNeuron& neuron, std::initializer_list<double> nets) {
  TimedNeuron::State state;
  std::string text;
  for (const double net : nets) {
    const NeuronOutput output = step(neuron, net, state);
    EXPECT_EQ(output.out, output.acting);
    text += output.out == 1 ? '+' : '0';
  }
  return text;
}

TEST(TimedNeuron, APulseHasItsTimeWhateverTheNetDoesMeanwhile) {
  EXPECT_EQ(outputs({3, 0.5}, {1, 0, 0, 0, 0}), "+++00");
  EXPECT_EQ(outputs({3, 0.5}, {0, 1, 1, 1, 1, 1}), "0+++00");
  EXPECT_EQ(outputs({1, 0.5}, {1, 0, 1, 0}), "+0+0");
  EXPECT_EQ(outputs({0, 0.5}, {1, 0, 1}), "000");
}

TEST(TimedNeuron, FiresAboveItsThresholdOnly) {
  EXPECT_EQ(outputs({2, 0.5}, {0.5, 0.5, 0.25, -3}), "0000");
}

TEST(TimedNeuron, FiresOncePerCrossing) {
  EXPECT_EQ(outputs({2, 0.5}, {1, 1, 1, 1, 0, 1, 0, 0}), "++000++0");
}

TEST(TimedNeuron, ACrossingDuringAPulseIsLost) {
  EXPECT_EQ(outputs({4, 0.5}, {1, 0, 1, 1, 1, 1, 0, 1}), "++++000+");
}

TEST(TimedNeuron, TimesAreRoundedDown) {
  const double time = 2.512;
  EXPECT_EQ(TimedNeuron::from_genes({&time, 1}, 0.5).time, 2);
}

}  // namespace
}  // namespace lamprey::science::neurons
