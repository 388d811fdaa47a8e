#include "robot_bridge/claims.hpp"

#include <array>
#include <cinttypes>
#include <cstdio>

namespace lamprey::robot_bridge {
namespace {

std::string name_of(std::uint64_t asker) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016" PRIx64, asker);
  return text.data();
}

}  // namespace

Claims::Answer Claims::claim(std::uint64_t asker, std::uint64_t token, Clock::time_point now) {
  if (in_force(now)) {
    if (asker == holder_ && (token == token_ || token == 0)) {
      renew(now);
      return {.granted = true, .reason = {}, .token = token_};
    }
    return {.reason = "the claim is held by " + name_of(holder_)};
  }
  if (token != 0) return {.reason = "claim " + std::to_string(token) + " is over"};
  holder_ = asker;
  ++token_;
  renew(now);
  return {.granted = true, .reason = {}, .token = token_, .is_new = true};
}

Claims::Answer Claims::release(std::uint64_t asker, std::uint64_t token, Clock::time_point now) {
  if (in_force(now) && token == token_ && asker != holder_) {
    return {.reason = "the claim is held by " + name_of(holder_)};
  }
  if (token == token_) revoke();
  return {.granted = true, .reason = {}, .token = token};
}

}  // namespace lamprey::robot_bridge
