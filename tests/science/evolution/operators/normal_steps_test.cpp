#include "science/evolution/operators/normal_steps.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace lamprey::science::evolution::operators {
namespace {

WordSequence sequence(std::uint32_t cycle) {
  return {random::Stream(9), cycle, random::Purpose::mutation, 0};
}

TEST(NormalSteps, HaveTheirStandardDeviationInStepUnits) {
  GenePlan plan;
  plan.genes = {{.minimum = -1000, .maximum = 1000, .step_unit = 1},
                {.minimum = -1000, .maximum = 1000, .step_unit = 0.1},
                {.minimum = -1000, .maximum = 1000, .step_unit = 2}};
  std::vector<double> sums(3);
  std::vector<double> squares(3);
  constexpr int draws = 20'000;
  for (std::uint32_t cycle = 0; cycle < draws; ++cycle) {
    std::vector<double> genes(3);
    WordSequence words = sequence(cycle);
    add_normal_steps(plan, 3, words, genes);
    for (std::size_t gene = 0; gene < 3; ++gene) {
      sums[gene] += genes[gene];
      squares[gene] += genes[gene] * genes[gene];
    }
  }
  for (std::size_t gene = 0; gene < 3; ++gene) {
    const double wanted = 3 * plan.genes[gene].step_unit;
    EXPECT_NEAR(sums[gene] / draws, 0, 4 * wanted / std::sqrt(draws)) << gene;
    EXPECT_NEAR(squares[gene] / draws, wanted * wanted, 4 * wanted * wanted * std::sqrt(2.0 / draws)) << gene;
  }
}

TEST(NormalSteps, AreHeldWithinTheBounds) {
  GenePlan plan;
  plan.genes.assign(4, {.minimum = 0, .maximum = 1});
  for (std::uint32_t cycle = 0; cycle < 200; ++cycle) {
    std::vector<double> genes(4, 0.5);
    WordSequence words = sequence(cycle);
    add_normal_steps(plan, 5, words, genes);
    for (const double gene : genes) EXPECT_TRUE(gene >= 0 && gene <= 1) << gene;
  }
}

// ln σ' is normal with mean ln σ and variance 1/n.
TEST(SelfAdaptation, IsLogNormalWithTheOldStandardDeviationAsItsMedian) {
  double sum = 0;
  double squares = 0;
  constexpr int draws = 20'000;
  for (std::uint32_t cycle = 0; cycle < draws; ++cycle) {
    const double logarithm = std::log(adapted_standard_deviation(2, sequence(cycle).normal(0), 9) / 2);
    sum += logarithm;
    squares += logarithm * logarithm;
  }
  EXPECT_NEAR(sum / draws, 0, 4 * std::sqrt(1.0 / 9 / draws));
  EXPECT_NEAR(squares / draws, 1.0 / 9, 4.0 / 9 * std::sqrt(2.0 / draws));
  EXPECT_EQ(adapted_standard_deviation(2, 0, 9), 2);
}

}  // namespace
}  // namespace lamprey::science::evolution::operators
