#pragma once

#include "science/networks/children.hpp"
#include "science/saving/archive.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace lamprey::science::networks {

// The network of 7.4.4 (fig. 7.23, second eq. 7.11): four mother neurons, each a clock, with two child neurons each,
// left and right. A child drives one servo of the quadruped.

/// A mother's times in time steps, in the same range. A mother whose link is off has a stopped clock: it makes no edge.
struct MotherTimes {
  double on = 0;
  double off = 0;
  bool linked = true;

  bool operator==(const MotherTimes&) const = default;
};

struct FourMotherNetwork {
  std::array<MotherTimes, mothers> mother_times{};
  std::array<ChildTimes, children> child_times{};

  bool operator==(const FourMotherNetwork&) const = default;
};

/// A network in whole time steps: 8.3.1 has a T_ON of 2.512 give two pulses, so every time is rounded down. A phase is
/// open from floor(D) after its edge and for floor(T) steps.
struct FourMotherSteps {
  std::array<std::int32_t, mothers> mother_on;
  std::array<std::int32_t, mothers> mother_period;
  std::array<bool, mothers> linked;
  std::array<std::int16_t, children> on_opens;
  std::array<std::int16_t, children> on_closes;
  std::array<std::int16_t, children> off_opens;
  std::array<std::int16_t, children> off_closes;
};

FourMotherSteps whole_steps(const FourMotherNetwork& network);

/// Time since an edge is counted to here and no further: every window has closed by then. Also: no edge yet.
inline constexpr std::int16_t long_ago = 255;

/// Where the clocks and the pending windows are between two steps.
struct FourMotherState {
  std::array<std::int32_t, mothers> elapsed{};  ///< of the mother's present period
  std::array<bool, mothers> firing{};           ///< the mother's output in the step before; off before the first
  std::array<std::int16_t, children> since_on_edge;
  std::array<std::int16_t, children> since_off_edge;

  FourMotherState() {
    since_on_edge.fill(long_ago);
    since_off_edge.fill(long_ago);
  }
  bool operator==(const FourMotherState&) const = default;
};

void fields(auto& archive, saving::Of<FourMotherState> auto& state) {
  saving::wholes(archive, "elapsed", state.elapsed, 0, static_cast<std::int32_t>(2 * maximum_time));
  saving::flags(archive, "firing", state.firing);
  saving::wholes(archive, "since_on_edge", state.since_on_edge, 0, long_ago);
  saving::wholes(archive, "since_off_edge", state.since_off_edge, 0, long_ago);
}

/// One time step of eq. 7.11 (second). A mother fires for T_ON steps, then rests for T_OFF; its first rising edge is
/// at the first step. An edge is a change of its output, so a mother with T_ON = 0 makes none, and one with T_OFF = 0
/// only the first. A rising edge starts its children's on-phase (silent for D1, then +1 for T_ON), a falling edge their
/// off-phase (silent for D2, then −1 for T_OFF). The phases run independently, a new edge restarts its own, and the
/// output is their sum. Pure but for `state`.
inline ChildOutputs step(const FourMotherSteps& steps, FourMotherState& state) {
  for (std::size_t mother = 0; mother < mothers; ++mother) {
    if (!steps.linked[mother]) continue;
    const bool fires = state.elapsed[mother] < steps.mother_on[mother];
    if (fires != state.firing[mother]) {
      auto& phase = fires ? state.since_on_edge : state.since_off_edge;
      phase[child(mother, left)] = 0;
      phase[child(mother, right)] = 0;
      state.firing[mother] = fires;
    }
    const std::int32_t next = state.elapsed[mother] + 1;
    state.elapsed[mother] = next < steps.mother_period[mother] ? next : 0;
  }

  ChildOutputs outputs;
  for (std::size_t i = 0; i < children; ++i) {
    const std::int16_t on = state.since_on_edge[i];
    const std::int16_t off = state.since_off_edge[i];
    const int plus = within(on, steps.on_opens[i], steps.on_closes[i]);
    const int minus = within(off, steps.off_opens[i], steps.off_closes[i]);
    outputs[i] = static_cast<std::int16_t>(plus - minus);
    state.since_on_edge[i] = std::min(static_cast<std::int16_t>(on + 1), long_ago);
    state.since_off_edge[i] = std::min(static_cast<std::int16_t>(off + 1), long_ago);
  }
  return outputs;
}

}  // namespace lamprey::science::networks
