#include "science/evolution/operators/uniform_mutation.hpp"

#include "science/evolution/operators/choice.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace lamprey::science::evolution::operators {
namespace {

using random::Purpose;
using random::Stream;

WordSequence sequence(std::uint32_t cycle, Purpose purpose = Purpose::mutation) {
  return {Stream(7), cycle, purpose, 3};
}

TEST(WordSequence, GivesTheWordsOfItsAddressInWhateverOrderTheyAreAskedFor) {
  WordSequence words = sequence(5);
  for (const std::uint32_t n : {9U, 0U, 4U, 9U, 3U}) {
    EXPECT_EQ(words.word(n), Stream(7).block(5, Purpose::mutation, 3, n / 4)[n % 4]) << n;
  }
  EXPECT_EQ(words.unit(2), random::unit_interval(words.word(4), words.word(5)));
  const auto deviates = maths::normal_deviates(words.word(6), words.word(7));
  EXPECT_EQ(words.normal(6), deviates.first);
  EXPECT_EQ(words.normal(7), deviates.second);
}

TEST(ChooseDistinct, ChoosesEveryPairAsOftenAndNeverTheSameTwice) {
  std::map<std::set<std::uint32_t>, int> pairs;
  for (std::uint32_t cycle = 0; cycle < 10'000; ++cycle) {
    WordSequence words = sequence(cycle);
    const auto chosen = choose_distinct(words, 2, 5);
    ++pairs[{chosen.begin(), chosen.end()}];
  }
  EXPECT_EQ(pairs.size(), 10U);
  double chi_squared = 0;
  for (const auto& [pair, count] : pairs) {
    EXPECT_EQ(pair.size(), 2U);
    chi_squared += (count - 1000.0) * (count - 1000.0) / 1000;
  }
  EXPECT_LT(chi_squared, 27.9);  // 9 degrees of freedom; exceeded by one key of a thousand
}

TEST(ChooseDistinct, OfAllIsAPermutationAndOfNoneIsEmpty) {
  WordSequence words = sequence(0);
  EXPECT_TRUE(choose_distinct(words, 0, 6).empty());
  auto all = choose_distinct(words, 6, 6);
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
}

TEST(Drawn, AWholeGeneIsEachWholeNumberOfItsBoundsAsOften) {
  const Gene time{.minimum = 1, .maximum = 10, .whole = true};
  std::map<double, int> counts;
  for (std::uint32_t cycle = 0; cycle < 10'000; ++cycle) ++counts[drawn(time, sequence(cycle).word(0))];
  EXPECT_EQ(counts.size(), 10U);
  EXPECT_EQ(counts.begin()->first, 1);
  EXPECT_EQ(counts.rbegin()->first, 10);
  double chi_squared = 0;
  for (const auto& [value, count] : counts) chi_squared += (count - 1000.0) * (count - 1000.0) / 1000;
  EXPECT_LT(chi_squared, 27.9);  // 9 degrees of freedom
}

TEST(Drawn, ARealGeneIsUniformWithinItsBounds) {
  const Gene weight{.minimum = -10, .maximum = 30};
  double sum = 0;
  double squares = 0;
  constexpr int draws = 20'000;
  for (std::uint32_t cycle = 0; cycle < draws; ++cycle) {
    const double value = drawn(weight, sequence(cycle).word(0));
    ASSERT_GE(value, -10);
    ASSERT_LE(value, 30);
    sum += value - 10;
    squares += (value - 10) * (value - 10);
  }
  // Variance 40²/12; that of the squares is 40⁴/180. Four standard errors.
  EXPECT_NEAR(sum / draws, 0, 4 * std::sqrt(1600.0 / 12 / draws));
  EXPECT_NEAR(squares / draws, 1600.0 / 12, 4 * std::sqrt(2'560'000.0 / 180 / draws));
  EXPECT_EQ(drawn(weight, 0), -10);
  EXPECT_LE(drawn(weight, 0xffffffffU), 30);
  EXPECT_EQ(drawn({.minimum = 4, .maximum = 4}, 0xffffffffU), 4);
}

TEST(DrawGenes, OfAMemberAreItsOwnBlocksWords) {
  GenePlan plan;
  plan.genes.assign(6, {.minimum = 0, .maximum = 1});
  const auto genes = draw_genes(Stream(7), 11, plan);
  ASSERT_EQ(genes.size(), 6U);
  EXPECT_EQ(genes[1], drawn(plan.genes[1], Stream(7).block(11, Purpose::initial_genes, 0)[1]));
  EXPECT_EQ(genes[5], drawn(plan.genes[5], Stream(7).block(11, Purpose::initial_genes, 1)[1]));
  EXPECT_NE(genes, draw_genes(Stream(7), 12, plan));
}

// 6.2.2.7: 25 % of two parameters act on none, 25 % of three (0.75) are rounded up to one.
TEST(MutatedCount, RoundsAsTheThesisDoes) {
  EXPECT_EQ(mutated_count(2, 25), 0U);
  EXPECT_EQ(mutated_count(3, 25), 1U);
  EXPECT_EQ(mutated_count(8, 25), 2U);  // 6.2.2.4
  EXPECT_EQ(mutated_count(10, 12.5), 1U);
  EXPECT_EQ(mutated_count(10, 100), 10U);
  EXPECT_EQ(mutated_count(10, 0), 0U);
}

TEST(RedrawSome, DrawsExactlySoManyAnewAndEveryGeneAsOften) {
  GenePlan plan;
  plan.genes.assign(8, {.minimum = 0, .maximum = 1});
  std::vector<int> counts(8);
  for (std::uint32_t cycle = 0; cycle < 4000; ++cycle) {
    std::vector<double> genes(8, 5.0);
    WordSequence choice = sequence(cycle, Purpose::mutation_choice);
    WordSequence values = sequence(cycle);
    redraw_some(plan, 2, choice, values, genes);
    EXPECT_EQ(std::count(genes.begin(), genes.end(), 5.0), 6);
    for (std::uint32_t gene = 0; gene < 8; ++gene) counts[gene] += genes[gene] != 5.0;
  }
  double chi_squared = 0;
  for (const int count : counts) chi_squared += (count - 1000.0) * (count - 1000.0) / 1000;
  EXPECT_LT(chi_squared, 24.3);  // below chi² of 7 degrees of freedom: drawn without replacement
}

TEST(RedrawEach, DrawsTheShareAnewThatItIsGiven) {
  GenePlan plan;
  plan.genes.assign(10, {.minimum = 0, .maximum = 1});
  const auto changed = [&](double percent) {
    long total = 0;
    for (std::uint32_t cycle = 0; cycle < 2000; ++cycle) {
      std::vector<double> genes(10, 5.0);
      WordSequence words = sequence(cycle);
      redraw_each(plan, percent, words, genes);
      total += 10 - std::count(genes.begin(), genes.end(), 5.0);
    }
    return total;
  };
  EXPECT_EQ(changed(0), 0);
  EXPECT_EQ(changed(100), 20'000);
  EXPECT_NEAR(static_cast<double>(changed(20)), 4000, 4 * std::sqrt(20'000 * 0.2 * 0.8));
}

}  // namespace
}  // namespace lamprey::science::evolution::operators
