#include "science/evolution/operators/selection.hpp"

#include "science/evolution/operators/choice.hpp"

#include <algorithm>
#include <numeric>

namespace lamprey::science::evolution::operators {

namespace {

std::uint32_t roulette_rank(std::uint32_t members, std::uint32_t word) {
  const auto wheel = static_cast<std::uint32_t>(std::uint64_t{members} * (members + 1) / 2);
  std::uint32_t place = random::bounded(word, wheel);
  std::uint32_t rank = 0;
  for (std::uint32_t slot = members; place >= slot; --slot) {
    place -= slot;
    ++rank;
  }
  return rank;
}

}  // namespace

std::vector<std::uint32_t> ranking(std::span<const double> costs) {
  std::vector<std::uint32_t> positions(costs.size());
  std::iota(positions.begin(), positions.end(), 0U);
  std::stable_sort(positions.begin(), positions.end(),
                   [costs](std::uint32_t left, std::uint32_t right) { return costs[left] < costs[right]; });
  return positions;
}

std::uint32_t select_rank(Selection selection, std::uint32_t tournament_size, std::uint32_t members,
                          WordSequence& words) {
  if (selection == Selection::truncation) return random::bounded(words.word(0), members / 2);
  if (selection == Selection::roulette) return roulette_rank(members, words.word(0));
  const auto competitors = choose_distinct(words, tournament_size, members);
  return *std::min_element(competitors.begin(), competitors.end());
}

}  // namespace lamprey::science::evolution::operators
