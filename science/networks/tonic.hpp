#pragma once

#include "science/networks/children.hpp"
#include "science/saving/archive.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace lamprey::science::networks {

// The three-layer network of 9.3 (eq. 9.1, figs 9.1 to 9.3): four mother neurons, one per leg, each with a vertical and
// a horizontal child neuron. An input tonic, a pulse of +1 or −1 for each mother, decides the gait; the mothers pass
// the pulses round. As in the thesis's own trials the vertical children stay passive.
//
// A child that receives +1 after −1:  Net = Input·Weight,    Output = 1 + 1/(1 + e^−Net)
//                    … +1 after +1:  Net = −Input·Weight,   Output = 1 + 1/(1 + e^−Net)
//                    … −1:           no action: the output stays. (Eq. 9.1 says so of −1 after −1 and is silent on −1
//                                    after +1.)
// The pulse before the first counts as −1.

/// In the order of the table in 9.3, clockwise.
enum TonicMother : std::uint8_t { right_front = 0, right_back = 1, left_back = 2, left_front = 3 };
inline constexpr std::size_t tonic_mothers = 4;

constexpr std::array<std::uint8_t, tonic_mothers> horizontal_child_of_tonic_mother{3, 7, 6, 2};

/// −1 or +1 per mother.
using Tonic = std::array<std::int16_t, tonic_mothers>;

/// Genes are reals: the pulse is the sign, +1 at 0.
constexpr std::int16_t pulse_of_gene(double gene) {
  return gene < 0 ? std::int16_t{-1} : std::int16_t{1};
}

/// The rows of the table of tonics in 9.3; the values are its numbers.
enum class TonicGait : std::uint8_t { walk = 1, gallop = 2, trot = 3, pace = 4 };
inline constexpr std::array<Tonic, 4> table_of_tonics{
    {{+1, -1, -1, -1}, {+1, -1, -1, +1}, {+1, -1, +1, -1}, {+1, +1, -1, -1}}};

constexpr const Tonic& tonic_of(TonicGait gait) {
  return table_of_tonics[static_cast<std::size_t>(gait) - 1];
}
/// The gait whose row the tonic is, exactly; twelve of the sixteen tonics are no row.
std::optional<TonicGait> gait_of(const Tonic& tonic);

struct TonicNetwork {
  Tonic tonic{-1, -1, -1, -1};
  /// From each mother to its horizontal child (fig. 9.1: 2.5).
  std::array<double, tonic_mothers> weights{};

  bool operator==(const TonicNetwork&) const = default;
};

/// The output of a child that never acted: the middle of eq. 9.1's range, at which a servo stands.
inline constexpr double resting_output = 1.5;
/// How many time steps the pulses stay before they are passed on: a unit of the gait (fig. 7.12).
inline constexpr std::int32_t steps_per_shift = 10;
/// A swing is three shifts clockwise (fig. 9.2a), then three back (fig. 9.2b).
inline constexpr std::int32_t shifts_one_way = 3;
inline constexpr std::int32_t shifts_per_swing = 2 * shifts_one_way;

/// Servo positions are calibrated as in fig. 9.3, which is lost: an output q of 1..2 is the position 10 + 10·(q − 1.5),
/// so that the middle is standing. The actuator rounds it.
constexpr double position_of_output(double output) {
  return 10 + 10 * (output - resting_output);
}

/// What does not change in an evaluation: the two outputs of each child, as positions.
struct TonicSteps {
  Tonic tonic;
  std::array<double, tonic_mothers> activated;  ///< +1 after −1
  std::array<double, tonic_mothers> reversed;   ///< +1 after +1
};

TonicSteps whole_steps(const TonicNetwork& network);

struct TonicState {
  std::int32_t step_of_swing = 0;  ///< 0..shifts_per_swing · steps_per_shift − 1; 0: the pulses are where they began
  Tonic previous{-1, -1, -1, -1};  ///< the pulse each child received before
  std::array<double, tonic_mothers> positions{10, 10, 10, 10};

  bool operator==(const TonicState&) const = default;
};

void fields(auto& archive, saving::Of<TonicState> auto& state) {
  archive.whole("step_of_swing", state.step_of_swing, 0, shifts_per_swing * steps_per_shift - 1);
  saving::wholes(archive, "previous", state.previous, -1, 1);
  saving::reals(archive, "positions", state.positions);
}

/// How many places clockwise the pulses are after `shift` shifts of a swing, 0..shifts_per_swing − 1.
constexpr std::int32_t places_clockwise(std::int32_t shift) {
  return shift <= shifts_one_way ? shift : shifts_per_swing - shift;
}

/// One time step; wanted positions. In the first of each steps_per_shift steps the mothers send their pulses: the tonic
/// itself first, then after each shift. Pure but for `state`.
ChildLevels step(const TonicSteps& steps, TonicState& state);

}  // namespace lamprey::science::networks
