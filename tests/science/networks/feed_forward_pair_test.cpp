#include "science/networks/feed_forward_pair.hpp"

#include "science/neurons/acting_output.hpp"
#include "science/neurons/net_as_on_time.hpp"
#include "science/neurons/threshold.hpp"

#include <array>
#include <gtest/gtest.h>
#include <string>

namespace lamprey::science::networks {
namespace {

using neurons::ActingOutputNeuron;
using neurons::NetAsOnTimeNeuron;
using neurons::ThresholdNeuron;

/// Fig. 6.19: T_ON, T_OFF, W21, θ; T_ON, T_OFF, W12, θ.
constexpr std::array<double, 8> figure_6_19{2, 2, -2, 0.5, 2, 2, -2, 0.5};

template <typename Neuron>
std::array<std::string, 2> outputs(const Pair<Neuron>& network, int time_steps) {
  PairState<Neuron> state;
  std::array<std::string, 2> texts;
  for (int t = 0; t < time_steps; ++t) {
    const PairStep done = step(network, state);
    for (std::size_t i = 0; i < pair_size; ++i) texts[i] += done.out[i] > 0 ? '+' : '-';
  }
  return texts;
}

TEST(FeedForwardPair, HasNoRecurrentConnections) {
  const auto network =
      pair_from_genes<FeedForwardPair, ThresholdNeuron>(std::array<double, 8>{1, 2, 0.21, 0.3, 4, 5, 0.12, 0.6});
  EXPECT_EQ(network.weight[0], (std::array{0.0, 0.21})) << "W21";
  EXPECT_EQ(network.weight[1], (std::array{0.12, 0.0})) << "W12";
  EXPECT_EQ(network.neuron[0].threshold, 0.3);
  EXPECT_EQ(network.neuron[1].on_time, 4);
  EXPECT_EQ(network.neuron[1].threshold, 0.6);
}

TEST(FeedForwardPair, NetsAreThePartnersOutputTimesItsWeight) {
  const auto network = pair_from_genes<FeedForwardPair, ThresholdNeuron>(figure_6_19);
  PairState<ThresholdNeuron> state;
  EXPECT_EQ(step(network, state).net, (std::array{2.0, -2.0}));
}

TEST(FeedForwardPair, PerformsAsTheRecurrentPairWithoutTheActingOutput) {
  const auto texts = outputs(pair_from_genes<FeedForwardPair, ThresholdNeuron>(figure_6_19), 10);
  EXPECT_EQ(texts[0], "++----++--");
  EXPECT_EQ(texts[1], "---++----+");
}

TEST(FeedForwardPair, IsInAntiphaseWithTheActingOutput) {
  const auto texts = outputs(pair_from_genes<FeedForwardPair, ActingOutputNeuron>(figure_6_19), 10);
  EXPECT_EQ(texts[0], "++--++--++");
  EXPECT_EQ(texts[1], "--++--++--");
}

TEST(FeedForwardPair, TheWorkedNetsOf6227SetTheOnTime) {
  // Without self-recurrent connections the example's weights of −4 do not fire; 4 fires for four steps.
  for (const double weight : {-4.0, 4.0}) {
    const auto network = pair_from_genes<FeedForwardPair, NetAsOnTimeNeuron>(std::array{0.0, weight});
    PairState<NetAsOnTimeNeuron> state;
    EXPECT_EQ(step(network, state).net[1], weight);
  }
  const auto network = pair_from_genes<FeedForwardPair, NetAsOnTimeNeuron>(std::array{0.0, 4.0});
  EXPECT_EQ(outputs(network, 8)[1], "++++----");
}

TEST(FeedForwardPair, NetsOfTenGiveTheStrideOfTen) {
  const auto network = pair_from_genes<FeedForwardPair, NetAsOnTimeNeuron>(std::array{-10.0, -10.0});
  const auto texts = outputs(network, 40);
  EXPECT_EQ(texts[0], "++++++++++----------++++++++++----------");
  EXPECT_EQ(texts[1], "----------++++++++++----------++++++++++");
}

}  // namespace
}  // namespace lamprey::science::networks
