#include "science/evolution/operators/crossover.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <vector>

namespace lamprey::science::evolution::operators {
namespace {

using Genes = std::vector<double>;

const Genes mother{1, 1, 1, 1, 1};
const Genes father{2, 2, 2, 2, 2};

GenePlan plan_of(std::size_t genes, double minimum = -100, double maximum = 100) {
  GenePlan plan;
  plan.genes.assign(genes, {.minimum = minimum, .maximum = maximum});
  return plan;
}

WordSequence sequence(std::uint32_t cycle) {
  return {random::Stream(5), cycle, random::Purpose::crossover, 0};
}

Children crossed(Crossover crossover, std::uint32_t cycle, const Genes& m = mother, const Genes& f = father,
                 double alpha = 0.5) {
  WordSequence words = sequence(cycle);
  return cross(crossover, alpha, plan_of(m.size()), m, f, words);
}

/// How often the first child is which; the second is always the other way round.
std::map<Genes, int> first_children(Crossover crossover, int times) {
  std::map<Genes, int> counts;
  for (int cycle = 0; cycle < times; ++cycle) {
    const Children children = crossed(crossover, static_cast<std::uint32_t>(cycle));
    ++counts[children.first];
    for (std::size_t gene = 0; gene < 5; ++gene) EXPECT_EQ(children.first[gene] + children.second[gene], 3);
  }
  return counts;
}

double chi_squared(const std::map<Genes, int>& counts, double expected) {
  double sum = 0;
  for (const auto& [genes, count] : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

TEST(OnePoint, ExchangesTheTailFromAnyInnerPointAsOften) {
  const auto counts = first_children(Crossover::one_point, 4000);
  EXPECT_EQ(counts.size(), 4U);
  for (const Genes& child : {Genes{1, 2, 2, 2, 2}, {1, 1, 2, 2, 2}, {1, 1, 1, 2, 2}, {1, 1, 1, 1, 2}}) {
    EXPECT_TRUE(counts.contains(child));
  }
  EXPECT_LT(chi_squared(counts, 1000), 16.3);  // 3 degrees of freedom; exceeded by one key of a thousand
}

TEST(TwoPoint, ExchangesAnInnerStretchOfAnyPlaceAsOften) {
  const auto counts = first_children(Crossover::two_point, 6000);
  EXPECT_EQ(counts.size(), 6U);
  for (const auto& [child, count] : counts) {
    EXPECT_EQ(child.front(), 1);
    EXPECT_EQ(child.back(), 1);
    EXPECT_TRUE(std::ranges::is_sorted(child.begin(), std::ranges::find(child, 2.0)));
  }
  EXPECT_LT(chi_squared(counts, 1000), 20.5);  // 5 degrees of freedom
}

TEST(Exchange, OfFewGenesDoesWhatItCan) {
  for (const auto crossover : {Crossover::one_point, Crossover::two_point}) {
    const Children two = crossed(crossover, 1, {1, 1}, {2, 2});
    EXPECT_EQ(two.first, (Genes{1, 2}));
    EXPECT_EQ(two.second, (Genes{2, 1}));
    EXPECT_EQ(crossed(crossover, 1, {1}, {2}).first, Genes{1});
  }
}

// Eq. 3.3, with one β for all genes and 1 − β for the next offspring.
TEST(Blend, LiesBetweenTheParentsByOneBetaAndTheSecondChildByItsComplement) {
  double sum = 0;
  constexpr int pairs = 4000;
  for (std::uint32_t cycle = 0; cycle < pairs; ++cycle) {
    const Children children = crossed(Crossover::blend, cycle, {0, 10}, {1, 30});
    const double beta = sequence(cycle).unit(0);
    EXPECT_DOUBLE_EQ(children.first[0], 1 - beta);
    EXPECT_DOUBLE_EQ(children.first[1], beta * 10 + (1 - beta) * 30);
    EXPECT_DOUBLE_EQ(children.second[0], beta);
    sum += beta;
  }
  EXPECT_NEAR(sum / pairs, 0.5, 4 * std::sqrt(1.0 / 12 / pairs));
}

// 3.3.2.6: outside the bounds of the parents, on the fitter one's side.
TEST(Michalewicz, LiesBeyondTheMother) {
  for (std::uint32_t cycle = 0; cycle < 200; ++cycle) {
    const Children children = crossed(Crossover::michalewicz, cycle, {4, -1}, {2, 3});
    const double beta = sequence(cycle).unit(0);
    EXPECT_DOUBLE_EQ(children.first[0], beta * 2 + 4);
    EXPECT_DOUBLE_EQ(children.first[1], beta * -4 - 1);
    EXPECT_DOUBLE_EQ(children.second[0], (1 - beta) * 2 + 4);
  }
}

TEST(BlxAlpha, IsUniformOverTheParentsStretchAndAlphaOfItBeyondEachEnd) {
  double sum = 0;
  double squares = 0;
  constexpr int pairs = 5000;
  for (std::uint32_t cycle = 0; cycle < pairs; ++cycle) {
    const Children children = crossed(Crossover::blx_alpha, cycle, {8, 0}, {4, 0}, 0.25);
    for (const double gene : {children.first[0], children.second[0]}) {
      ASSERT_GE(gene, 3);
      ASSERT_LE(gene, 9);
      sum += gene - 6;
      squares += (gene - 6) * (gene - 6);
    }
    EXPECT_EQ(children.first[1], 0) << "parents that agree have children that agree";
  }
  // Uniform over a width of 6: variance 3, that of the squares 6⁴/180.
  EXPECT_NEAR(sum / (2 * pairs), 0, 4 * std::sqrt(3.0 / (2 * pairs)));
  EXPECT_NEAR(squares / (2 * pairs), 3, 4 * std::sqrt(7.2 / (2 * pairs)));
}

TEST(Crossover, HoldsEveryGeneWithinItsBounds) {
  const GenePlan narrow = plan_of(2, 0, 1);
  for (const auto crossover : {Crossover::michalewicz, Crossover::blx_alpha}) {
    for (std::uint32_t cycle = 0; cycle < 100; ++cycle) {
      WordSequence words = sequence(cycle);
      const Genes high{1, 0.1};
      const Genes low{0, 0.9};
      const Children children = cross(crossover, 2, narrow, high, low, words);
      for (const Genes& child : {children.first, children.second}) {
        for (const double gene : child) EXPECT_TRUE(gene >= 0 && gene <= 1) << gene;
      }
    }
  }
}

TEST(Recombine, TakesEachGeneFromEitherParentAsOften) {
  std::map<Genes, int> counts;
  for (std::uint32_t cycle = 0; cycle < 8000; ++cycle) {
    WordSequence words = sequence(cycle);
    ++counts[recombine(Genes{1, 1, 1}, Genes{2, 2, 2}, words)];
  }
  EXPECT_EQ(counts.size(), 8U);
  EXPECT_LT(chi_squared(counts, 1000), 24.3);  // 7 degrees of freedom
}

}  // namespace
}  // namespace lamprey::science::evolution::operators
