#include "science/networks/recurrent_pair.hpp"

#include "science/neurons/acting_output.hpp"
#include "science/neurons/mcculloch_pitts.hpp"
#include "science/neurons/net_as_on_time.hpp"
#include "science/neurons/threshold.hpp"
#include "science/neurons/timed.hpp"

#include <array>
#include <gtest/gtest.h>
#include <string>
#include <type_traits>

namespace lamprey::science::networks {
namespace {

using neurons::ActingOutputNeuron;
using neurons::NetAsOnTimeNeuron;
using neurons::ThresholdNeuron;

static_assert(std::is_trivially_copyable_v<PairState<ThresholdNeuron>>);
static_assert(std::is_trivially_copyable_v<PairState<NetAsOnTimeNeuron>>);
static_assert(std::is_trivially_copyable_v<PairState<neurons::McCullochPittsNeuron>>);
static_assert(std::is_trivially_copyable_v<PairState<neurons::TimedNeuron>>);

using Values = std::array<std::int16_t, pair_size>;
using Nets = std::array<double, pair_size>;

/// Fig. 6.12: T_ON, T_OFF, W11, W21, θ; T_ON, T_OFF, W12, W22, θ.
constexpr std::array<double, 10> figure_6_12{2, 2, -1, -2, 0.5, 2, 2, -2, -1, 0.5};

template <typename Neuron>
struct Trial {
  Pair<Neuron> network;
  PairState<Neuron> state{};
  PairStep next() { return step(network, state); }
};

TEST(RecurrentPair, GenesAreTimesThenWeightsBySourceThenTheThreshold) {
  const auto network = pair_from_genes<RecurrentPair, ThresholdNeuron>(
      std::array<double, 10>{1, 2, 0.11, 0.21, 0.3, 4, 5, 0.12, 0.22, 0.6});
  EXPECT_EQ(network.neuron[0].on_time, 1);
  EXPECT_EQ(network.neuron[0].off_time, 2);
  EXPECT_EQ(network.weight[0], (Nets{0.11, 0.21})) << "W11, W21";
  EXPECT_EQ(network.neuron[0].threshold, 0.3);
  EXPECT_EQ(network.neuron[1].on_time, 4);
  EXPECT_EQ(network.neuron[1].off_time, 5);
  EXPECT_EQ(network.weight[1], (Nets{0.12, 0.22})) << "W12, W22";
  EXPECT_EQ(network.neuron[1].threshold, 0.6);
}

TEST(RecurrentPair, TheWorkedTableOf6221) {
  Trial<ThresholdNeuron> trial{pair_from_genes<RecurrentPair, ThresholdNeuron>(figure_6_12)};
  const PairStep t1 = trial.next();
  EXPECT_EQ(t1.net, (Nets{3, -3}));
  EXPECT_EQ(t1.out, (Values{1, -1}));
  EXPECT_EQ(trial.state.input[0], (Values{1, -1})) << "In2 of N1 from itself, In1 from N2";
  EXPECT_EQ(trial.state.input[1], (Values{1, -1})) << "In1 of N2 from N1, In2 from itself";

  const PairStep t2 = trial.next();
  EXPECT_EQ(t2.net[1], -1) << "printed −3, with inputs of +1 and −1";
  EXPECT_EQ(t2.out, (Values{1, -1})) << "N1 performs its on-cycle";

  const PairStep t3 = trial.next();
  EXPECT_EQ(t3.net[1], -1) << "printed −3";
  EXPECT_EQ(t3.out, (Values{-1, -1})) << "N1 is off; N2 has seen +1 still";

  const PairStep t4 = trial.next();
  EXPECT_EQ(t4.net[1], 3);
  EXPECT_EQ(t4.out, (Values{-1, 1})) << "N2 starts a step later than one would expect";
}

/// Outputs of both neurons over the steps, N1's first.
template <typename Neuron>
std::array<std::string, 2> outputs(const Pair<Neuron>& network, int time_steps) {
  Trial<Neuron> trial{network};
  std::array<std::string, 2> texts;
  for (int t = 0; t < time_steps; ++t) {
    const PairStep done = trial.next();
    for (std::size_t i = 0; i < pair_size; ++i) texts[i] += done.out[i] > 0 ? '+' : done.out[i] < 0 ? '-' : '0';
  }
  return texts;
}

TEST(RecurrentPair, WithoutTheActingOutputThePatternIsNotSymmetrical) {
  // Continued by hand from T4: N1 sees +1 of N2 in T5 and T6 (net −1) and fires in T7 (net +3); N2 likewise in T10.
  const auto texts = outputs(pair_from_genes<RecurrentPair, ThresholdNeuron>(figure_6_12), 10);
  EXPECT_EQ(texts[0], "++----++--");
  EXPECT_EQ(texts[1], "---++----+");
}

TEST(RecurrentPair, TheWorkedTableOf6222WithTheActingOutput) {
  Trial<ActingOutputNeuron> trial{pair_from_genes<RecurrentPair, ActingOutputNeuron>(figure_6_12)};
  const PairStep t1 = trial.next();
  EXPECT_EQ(t1.net, (Nets{3, -3}));
  EXPECT_EQ(t1.out, (Values{1, -1}));
  EXPECT_EQ(t1.acting, (Values{1, -1}));

  const PairStep t2 = trial.next();
  EXPECT_EQ(t2.net[1], -1) << "printed −3";
  EXPECT_EQ(t2.out, (Values{1, -1}));
  EXPECT_EQ(t2.acting, (Values{-1, -1})) << "N1 is about to go off";

  const PairStep t3 = trial.next();
  EXPECT_EQ(t3.net[1], 3);
  EXPECT_EQ(t3.out, (Values{-1, 1})) << "printed −1 for N2, whose net is above its threshold";
}

TEST(RecurrentPair, WithTheActingOutputItIsInAntiphaseForEver) {
  const auto texts = outputs(pair_from_genes<RecurrentPair, ActingOutputNeuron>(figure_6_12), 400);
  for (std::size_t t = 0; t < 400; ++t) {
    EXPECT_EQ(texts[0][t], t % 4 < 2 ? '+' : '-') << t;
    EXPECT_EQ(texts[1][t], t % 4 < 2 ? '-' : '+') << t;
  }
}

TEST(RecurrentPair, TheWorkedNetsOf6227SetTheOnTime) {
  // The example's inputs are +1, as N2's are at first. Its nets: −8 and 0 do not fire, 12 fires for twelve steps.
  struct Row {
    double from_partner;
    double from_self;
    double net;
    neurons::OnOffState cycle;
  };
  for (const Row& row : {Row{-4, -4, -8, {0, 0}}, Row{-4, 4, 0, {0, 0}}, Row{4, 8, 12, {11, 8}}}) {
    Trial<NetAsOnTimeNeuron> trial{
        pair_from_genes<RecurrentPair, NetAsOnTimeNeuron>(std::array{0.0, 0.0, row.from_partner, row.from_self})};
    const PairStep done = trial.next();
    EXPECT_EQ(done.net[1], row.net);
    EXPECT_EQ(trial.state.neuron[1], row.cycle) << "the first on-step is done";
    EXPECT_EQ(done.out[1], row.net > 0 ? 1 : -1);
  }
}

TEST(RecurrentPair, NetsAreEvaluatedAtTheSameTime) {
  // N1 turns 1 in the first step; N2, which would follow at once if it saw that, follows in the second.
  const auto network =
      pair_from_genes<RecurrentPair, neurons::McCullochPittsNeuron>(std::array<double, 6>{0, -1, 0.5, 2, -2, 0.5});
  EXPECT_EQ(outputs(network, 2)[0], "+0");
  EXPECT_EQ(outputs(network, 2)[1], "0+");
}

TEST(RecurrentPair, TimedNeuronsPassAPulseBackAndForth) {
  // N2's first net is +1: one pulse. N1 sees it in T2, N2 sees N1 in T3, and so on.
  const auto network =
      pair_from_genes<RecurrentPair, neurons::TimedNeuron>(std::array<double, 8>{1, 0, 1, 0.5, 1, 1, 0, 0.5});
  EXPECT_EQ(outputs(network, 6)[0], "0+0+0+");
  EXPECT_EQ(outputs(network, 6)[1], "+0+0+0");
}

}  // namespace
}  // namespace lamprey::science::networks
