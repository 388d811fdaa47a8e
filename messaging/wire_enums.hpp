#pragma once

#include "messaging/samples.hpp"

#include <cstdint>
#include <type_traits>

/// Enumerators as they come from the network, where any number may stand for them.
namespace lamprey::messaging {

inline constexpr WorkerState last_of(WorkerState) {
  return WorkerState::leaving;
}
inline constexpr LeaseKind last_of(LeaseKind) {
  return LeaseKind::drain;
}
inline constexpr ResultKind last_of(ResultKind) {
  return ResultKind::failed;
}
inline constexpr Verdict last_of(Verdict) {
  return Verdict::refused;
}

inline constexpr RobotState last_of(RobotState) {
  return RobotState::finalized;
}
inline constexpr RobotRequestKind last_of(RobotRequestKind) {
  return RobotRequestKind::place;
}
inline constexpr StepOutcome last_of(StepOutcome) {
  return StepOutcome::voided;
}

/// Sets `value` to the enumerator of that number; false if there is none.
template <class Enumeration, class Number>
bool set_enumerator(Enumeration& value, Number number) {
  const auto wide = static_cast<std::int64_t>(number);
  if (wide < 0 || wide > static_cast<std::int64_t>(last_of(Enumeration{}))) return false;
  value = static_cast<Enumeration>(wide);
  return true;
}

/// The generated enumerator of the same number (idl/lamprey.idl lists them in the same order).
template <class Wire, class Enumeration>
Wire to_enumerator(Enumeration value) {
  return static_cast<Wire>(static_cast<std::underlying_type_t<Enumeration>>(value));
}

}  // namespace lamprey::messaging
