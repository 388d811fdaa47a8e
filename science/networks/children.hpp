#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lamprey::science::networks {

// What every network of the quadruped has: eight output neurons, or servos' programs, the children of 7.4.4. Child i
// drives servo i.

enum Mother : std::uint8_t { front_vertical = 0, front_horizontal = 1, back_vertical = 2, back_horizontal = 3 };
enum Side : std::uint8_t { left = 0, right = 1 };
inline constexpr std::size_t mothers = 4;
inline constexpr std::size_t children = 8;

constexpr std::size_t child(std::size_t mother, std::size_t side) {
  return 2 * mother + side;
}

inline constexpr std::array<std::uint8_t, 4> vertical_children{0, 1, 4, 5};
inline constexpr std::array<std::uint8_t, 4> horizontal_children{2, 3, 6, 7};

/// The children of the six pairs of legs that move together (4.2.2): front, back, left, right and the diagonals of
/// front left and back right, and of front right and back left.
inline constexpr std::array<std::array<std::uint8_t, 4>, 6> children_of_leg_pairs{
    {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 2, 4, 6}, {1, 3, 5, 7}, {0, 2, 5, 7}, {1, 3, 4, 6}}};

/// A child's times in time steps, in this order; reals within minimum_time..maximum_time.
using ChildTimes = std::array<double, 4>;
enum ChildTime : std::uint8_t { delay_before_on = 0, on_time = 1, delay_before_off = 2, off_time = 3 };

inline constexpr double minimum_time = 0;
inline constexpr double maximum_time = 100;

/// −1, 0 or +1 per child.
using ChildOutputs = std::array<std::int16_t, children>;

/// The wanted position of each child's servo, where a network puts out levels instead of pulses.
using ChildLevels = std::array<double, children>;

/// 1 if first <= time < end, else 0; without a branch, so that a compiler can do it for all children at once.
constexpr int within(std::int16_t time, std::int16_t first, std::int16_t end) {
  return int{first <= time} & int{time < end};
}

}  // namespace lamprey::science::networks
