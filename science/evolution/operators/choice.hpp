#pragma once

#include "science/evolution/operators/word_sequence.hpp"

#include <cstdint>
#include <vector>

namespace lamprey::science::evolution::operators {

/// `count` different ones of 0..of−1, for count ≤ of, in the order in which they were drawn; every such order is as
/// likely. A partial Fisher–Yates shuffle: draw i swaps place i with place i + bounded(word i, of − i).
std::vector<std::uint32_t> choose_distinct(WordSequence& words, std::uint32_t count, std::uint32_t of);

}  // namespace lamprey::science::evolution::operators
