#include "science/neurons/acting_output.hpp"
#include "science/neurons/net_as_on_time.hpp"
#include "science/neurons/threshold.hpp"

#include <array>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace lamprey::science::neurons {
namespace {

struct Texts {
  std::string out;
  std::string acting;
};

template <typename Neuron>
Texts outputs(const Neuron& neuron, const std::vector<double>& nets) {
  OnOffState state;
  Texts texts;
  for (const double net : nets) {
    const NeuronOutput output = step(neuron, net, state);
    texts.out += output.out == 1 ? '+' : '-';
    texts.acting += output.acting == 1 ? '+' : '-';
  }
  return texts;
}

TEST(ThresholdNeuron, FiresItsOnTimeAndThenItsOffTimeFromTheStepInWhichItsNetIsAbove) {
  const auto [out, acting] = outputs(ThresholdNeuron{2, 3, 0.5}, {0, 1, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(out, "-++-----");
  EXPECT_EQ(acting, out);
}

TEST(ThresholdNeuron, DoesNotConsiderItsInputsDuringACycle) {
  EXPECT_EQ(outputs(ThresholdNeuron{2, 2, 0.5}, std::vector<double>(10, 1)).out, "++--++--++");
  EXPECT_EQ(outputs(ThresholdNeuron{2, 2, 0.5}, {1, -9, 9, 9, -9, 1}).out, "++---+");
}

TEST(ThresholdNeuron, ANetAtItsThresholdDoesNotFire) {
  EXPECT_EQ(outputs(ThresholdNeuron{2, 2, 0.5}, {0.5, 0.5, 0.5}).out, "---");
}

TEST(ThresholdNeuron, ABarrierAsInTheWorkedNumbersOf6226) {
  // In = 1: W 2 under θ 2.5, W 3 under θ 3.5, then W 4 over θ 3.75 with T_ON 8.
  EXPECT_EQ(outputs(ThresholdNeuron{5, 5, 2.5}, std::vector<double>(12, 1 * 2.0)).out, "------------");
  EXPECT_EQ(outputs(ThresholdNeuron{7, 7, 3.5}, std::vector<double>(12, 1 * 3.0)).out, "------------");
  EXPECT_EQ(outputs(ThresholdNeuron{8, 8, 3.75}, std::vector<double>(12, 1 * 4.0)).out, "++++++++----");
  // 100 % mutation: W 2 under θ 3, then 3 under 4. The first net is 2; 6.2.2.6 prints 3.
  EXPECT_EQ(outputs(ThresholdNeuron{5, 5, 3}, std::vector<double>(4, 1 * 2.0)).out, "----");
  EXPECT_EQ(outputs(ThresholdNeuron{5, 5, 4}, std::vector<double>(4, 1 * 3.0)).out, "----");
}

TEST(ThresholdNeuron, TimesAreRoundedDown) {
  const std::array<double, 2> times{2.512, 1.99};
  const ThresholdNeuron neuron = ThresholdNeuron::from_genes(times, 0.5);
  EXPECT_EQ(neuron.on_time, 2);
  EXPECT_EQ(neuron.off_time, 1);
  EXPECT_EQ(neuron.threshold, 0.5);
}

TEST(ActingOutputNeuron, IsInvertedOnTheLastOnStepOnly) {
  const auto [out, acting] = outputs(ActingOutputNeuron{{3, 2, 0.5}}, {0, 1, 0, 0, 0, 0, 0, 1});
  EXPECT_EQ(out, "-+++---+");
  EXPECT_EQ(acting, "-++----+");
  EXPECT_EQ(outputs(ActingOutputNeuron{{1, 1, 0.5}}, {1, 0, 1, 0}).acting, "----");
}

TEST(NetAsOnTimeNeuron, TheNetIsTheOnTimeAndTheRestOfT3TheOffTime) {
  EXPECT_EQ(on_and_off_time, 20);
  EXPECT_EQ(cycle_of_net(4), (OnOffState{4, 16}));
  EXPECT_EQ(cycle_of_net(10), (OnOffState{10, 10}));
  EXPECT_EQ(cycle_of_net(9.99), (OnOffState{9, 11})) << "whole steps";
  EXPECT_EQ(cycle_of_net(19.99), (OnOffState{19, 1}));
  EXPECT_EQ(cycle_of_net(20), (OnOffState{20, 0}));
  EXPECT_EQ(cycle_of_net(400), (OnOffState{20, 0})) << "never above T3";
  EXPECT_EQ(cycle_of_net(0.5), (OnOffState{0, 20})) << "fires for no whole step, and listens again after T3";
}

TEST(NetAsOnTimeNeuron, ANetOfZeroOrLessDoesNotFire) {
  EXPECT_TRUE(listens(cycle_of_net(0)));
  EXPECT_TRUE(listens(cycle_of_net(-8)));
}

TEST(NetAsOnTimeNeuron, RunsItsCycleWithTheActingOutput) {
  std::vector<double> nets(23, 0);
  nets[1] = 3.5;
  nets[22] = -1;
  const auto [out, acting] = outputs(NetAsOnTimeNeuron{}, nets);
  EXPECT_EQ(out, "-+++-------------------");
  EXPECT_EQ(acting, "-++--------------------");
  nets[20] = 5;
  EXPECT_EQ(outputs(NetAsOnTimeNeuron{}, nets).out, "-+++-------------------") << "T3 lasts from step 1 to 20";
  nets[21] = 5;
  EXPECT_EQ(outputs(NetAsOnTimeNeuron{}, nets).out, "-+++-----------------++");
}

}  // namespace
}  // namespace lamprey::science::neurons
