#include "science/evolution/operators/choice.hpp"

#include <numeric>
#include <utility>

namespace lamprey::science::evolution::operators {

std::vector<std::uint32_t> choose_distinct(WordSequence& words, std::uint32_t count, std::uint32_t of) {
  std::vector<std::uint32_t> places(of);
  std::iota(places.begin(), places.end(), 0U);
  for (std::uint32_t i = 0; i < count; ++i) {
    std::swap(places[i], places[i + random::bounded(words.word(i), of - i)]);
  }
  places.resize(count);
  return places;
}

}  // namespace lamprey::science::evolution::operators
