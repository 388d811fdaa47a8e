#pragma once

#include "science/networks/pair.hpp"

#include <array>
#include <cstddef>

namespace lamprey::science::networks {

/// The fully connected network of 6.2.2.1 (fig. 6.11): each neuron receives from its partner and from itself. Its
/// chromosome (fig. 6.23) has the weights W11 and W21 for N1, W12 and W22 for N2.
struct RecurrentPair {
  static constexpr std::array<std::array<std::size_t, 2>, pair_size> sources{{{0, 1}, {0, 1}}};
};

}  // namespace lamprey::science::networks
