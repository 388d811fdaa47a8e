#include "science/neurons/mcculloch_pitts.hpp"

#include <gtest/gtest.h>

namespace lamprey::science::neurons {
namespace {

int fires(double threshold, double net) {
  McCullochPittsNeuron::State state;
  const NeuronOutput output = step(McCullochPittsNeuron{threshold}, net, state);
  EXPECT_EQ(output.out, output.acting);
  return output.out;
}

TEST(McCullochPitts, TruthTables) {
  for (const int a : {0, 1}) {
    for (const int b : {0, 1}) {
      EXPECT_EQ(fires(2, a + b), a & b) << "and " << a << b;
      EXPECT_EQ(fires(1, a + b), a | b) << "or " << a << b;
      EXPECT_EQ(fires(1, a - b), a & (1 - b)) << "and not " << a << b;
      EXPECT_EQ(fires(-1, -a - b), 1 - (a & b)) << "nand " << a << b;
    }
    EXPECT_EQ(fires(0, -a), 1 - a) << "not " << a;
  }
}

TEST(McCullochPitts, GenesAreTheThresholdOnly) {
  EXPECT_EQ(McCullochPittsNeuron::from_genes({}, 0.25).threshold, 0.25);
}

}  // namespace
}  // namespace lamprey::science::neurons
