#pragma once

#include "science/networks/pair.hpp"

#include <array>
#include <cstddef>

namespace lamprey::science::networks {

/// What 6.2.2.3 calls a feed-forward network (fig. 6.18): each neuron receives from its partner only. Its chromosome
/// (fig. 6.24) has the weight W21 for N1 and W12 for N2.
struct FeedForwardPair {
  static constexpr std::array<std::array<std::size_t, 1>, pair_size> sources{{{1}, {0}}};
};

}  // namespace lamprey::science::networks
