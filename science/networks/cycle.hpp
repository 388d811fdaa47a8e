#pragma once

#include "science/networks/children.hpp"
#include "science/saving/archive.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace lamprey::science::networks {

// The ON/OFF cycle of fig. 7.11, which the neurons of eq. 7.10 and of the first eq. 7.11 run through once triggered:
// silent for D1, +1 for T_ON, silent for D2, −1 for T_OFF. It cannot be interrupted.

/// The cycles of all children in whole time steps: every time is rounded down (8.3.1).
struct CycleSteps {
  std::array<std::int16_t, children> on_opens;
  std::array<std::int16_t, children> on_closes;
  std::array<std::int16_t, children> off_opens;
  std::array<std::int16_t, children> ends;  ///< the off-window's end and the cycle's length; may be 0
};

/// Times are within minimum_time..maximum_time.
CycleSteps whole_steps(const std::array<ChildTimes, children>& times);

/// Where each child is in its cycle: time steps since it was triggered.
using CyclePlaces = std::array<std::int16_t, children>;
/// The place of a child that waits for a trigger.
inline constexpr std::int16_t waiting = -1;

constexpr CyclePlaces all_waiting() {
  CyclePlaces places{};
  places.fill(waiting);
  return places;
}

/// No place is further: networks::maximum_time, four times.
inline constexpr std::int16_t furthest_place = 400;

void places(auto& archive, saving::Of<CyclePlaces> auto& all) {
  saving::wholes(archive, "places", all, waiting, furthest_place);
}

/// A child whose times shrank in mid-cycle may be past its end: it waits too.
constexpr bool waits(const CycleSteps& steps, const CyclePlaces& places, std::size_t i) {
  return places[i] < 0 || places[i] >= steps.ends[i];
}

/// The output of each child at its place, which then is one step further; a cycle's end waits.
inline ChildOutputs advance_cycles(const CycleSteps& steps, CyclePlaces& places) {
  ChildOutputs outputs;
  for (std::size_t i = 0; i < children; ++i) {
    const std::int16_t place = places[i];
    const int plus = within(place, steps.on_opens[i], steps.on_closes[i]);
    const int minus = within(place, steps.off_opens[i], steps.ends[i]);
    outputs[i] = static_cast<std::int16_t>(plus - minus);
    const auto next = static_cast<std::int16_t>(place + 1);
    places[i] = place < 0 || next >= steps.ends[i] ? waiting : next;
  }
  return outputs;
}

}  // namespace lamprey::science::networks
