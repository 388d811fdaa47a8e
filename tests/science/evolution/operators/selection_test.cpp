#include "science/evolution/operators/selection.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace lamprey::science::evolution::operators {
namespace {

constexpr std::uint32_t members = 6;
constexpr int selections = 12'000;

std::array<int, members> chosen(Selection selection, std::uint32_t tournament_size = 2) {
  std::array<int, members> counts{};
  for (std::uint32_t cycle = 0; cycle < selections; ++cycle) {
    WordSequence words(random::Stream(3), cycle, random::Purpose::selection, 0);
    ++counts.at(select_rank(selection, tournament_size, members, words));
  }
  return counts;
}

/// Each rank's count is within four standard errors of what its probability says.
void expect_probabilities(const std::array<int, members>& counts, const std::array<double, members>& probabilities) {
  for (std::size_t rank = 0; rank < members; ++rank) {
    const double p = probabilities[rank];
    EXPECT_NEAR(counts[rank], selections * p, 4 * std::sqrt(selections * p * (1 - p))) << "rank " << rank;
  }
}

TEST(Ranking, PutsTheLowestCostFirstAndOfEqualsTheEarlierPosition) {
  const std::array costs{3.0, -5.0, 3.0, 1.0, -5.0};
  EXPECT_EQ(ranking(costs), (std::vector<std::uint32_t>{1, 4, 3, 0, 2}));
}

// 3.3.2.4: the top half is the breeding population.
TEST(Selection, TruncationGivesTheTopHalfEqualChancesAndTheRestNone) {
  expect_probabilities(chosen(Selection::truncation), {1.0 / 3, 1.0 / 3, 1.0 / 3, 0, 0, 0});
}

TEST(Selection, TheRouletteGivesEachRankItsSlot) {
  expect_probabilities(chosen(Selection::roulette), {6.0 / 21, 5.0 / 21, 4.0 / 21, 3.0 / 21, 2.0 / 21, 1.0 / 21});
}

// Of the 15 pairs of six, rank r is the fittest of 5 − r.
TEST(Selection, ATournamentOfTwoIsWonByTheFitterOfADifferentPair) {
  expect_probabilities(chosen(Selection::tournament), {5.0 / 15, 4.0 / 15, 3.0 / 15, 2.0 / 15, 1.0 / 15, 0});
}

TEST(Selection, ATournamentOfAllIsWonByTheFittestAndOneOfOneByAnyone) {
  expect_probabilities(chosen(Selection::tournament, members), {1, 0, 0, 0, 0, 0});
  constexpr double sixth = 1.0 / 6;
  expect_probabilities(chosen(Selection::tournament, 1), {sixth, sixth, sixth, sixth, sixth, sixth});
}

}  // namespace
}  // namespace lamprey::science::evolution::operators
