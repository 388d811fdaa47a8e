#pragma once

#include "science/networks/cycle.hpp"
#include "science/saving/archive.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace lamprey::science::networks {

// The network of 7.4.3 (fig. 7.21, first eq. 7.11): one mother neuron triggers all eight child neurons every T_D time
// steps. A triggered child runs through its cycle (fig. 7.11) once, then is silent until the next trigger.

struct OneMotherNetwork {
  std::array<ChildTimes, children> child_times{};
  double trigger_period = 1;  ///< T_D, within minimum_time..maximum_time; below one step it triggers in every step

  bool operator==(const OneMotherNetwork&) const = default;
};

struct OneMotherSteps {
  CycleSteps cycles;
  std::int32_t trigger_period;  ///< at least 1
};

inline OneMotherSteps whole_steps(const OneMotherNetwork& network) {
  return {.cycles = whole_steps(network.child_times),
          .trigger_period = std::max(1, static_cast<std::int32_t>(network.trigger_period))};
}

struct OneMotherState {
  std::int32_t since_trigger = 0;  ///< 0: the mother triggers in the next step
  CyclePlaces places = all_waiting();

  bool operator==(const OneMotherState&) const = default;
};

void fields(auto& archive, saving::Of<OneMotherState> auto& state) {
  archive.whole("since_trigger", state.since_trigger, 0, static_cast<std::int32_t>(maximum_time));
  places(archive, state.places);
}

/// One time step. The first trigger is at the first step. A trigger during a child's cycle is ignored by that child;
/// one in the step after its cycle starts it again. Pure but for `state`.
inline ChildOutputs step(const OneMotherSteps& steps, OneMotherState& state) {
  if (state.since_trigger == 0) {
    for (std::size_t i = 0; i < children; ++i) {
      if (waits(steps.cycles, state.places, i)) state.places[i] = 0;
    }
  }
  const std::int32_t next = state.since_trigger + 1;
  state.since_trigger = next < steps.trigger_period ? next : 0;
  return advance_cycles(steps.cycles, state.places);
}

}  // namespace lamprey::science::networks
