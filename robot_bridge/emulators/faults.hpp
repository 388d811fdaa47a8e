#pragma once

#include "robot_bridge/emulators/controller.hpp"

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>

namespace lamprey::robot_bridge::emulators {

/// What goes wrong with answers, on demand. Faults add up.
class Faults {
 public:
  /// The same seed and answers give the same noise.
  explicit Faults(std::uint64_t seed) : random_(seed) {}

  bool silence = false;      ///< no answer leaves
  bool partial = false;      ///< of each answer only the first half leaves, rounded down
  double noise = 0;          ///< the share of octets, 0..1, that are replaced or preceded by a random one
  Time slow = Time::zero();  ///< so much later each answer leaves

  /// What leaves in the answer's place; nothing where nothing does.
  std::optional<Answer> apply(Answer answer);

  /// All of them off.
  void clear();

 private:
  double uniform();

  std::mt19937_64 random_;
};

}  // namespace lamprey::robot_bridge::emulators
