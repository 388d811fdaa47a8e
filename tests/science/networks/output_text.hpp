#pragma once

#include "science/networks/children.hpp"

#include <array>
#include <string>

namespace lamprey::science::networks {

inline char sign_of(int output) {
  return output > 0 ? '+' : output < 0 ? '-' : '0';
}

/// What each child puts out in the next time steps, as +, − and 0.
template <typename Steps, typename State>
std::array<std::string, children> output_text(const Steps& steps, State& state, int time_steps) {
  std::array<std::string, children> text;
  for (int t = 0; t < time_steps; ++t) {
    const ChildOutputs outputs = step(steps, state);
    for (std::size_t i = 0; i < children; ++i) text[i] += sign_of(outputs[i]);
  }
  return text;
}

}  // namespace lamprey::science::networks
