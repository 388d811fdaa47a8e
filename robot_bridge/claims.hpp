#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace lamprey::robot_bridge {

using Clock = std::chrono::steady_clock;

/// Who may move the robot. One at a time: each claim has a token that is higher than any before it, whatever restarts,
/// and a lease on the bridge's steady clock. What carries a lower token is from somebody whose claim is over. Not
/// thread-safe.
class Claims {
 public:
  struct Answer {
    bool granted = false;
    std::string reason;       ///< of a refusal
    std::uint64_t token = 0;  ///< of the claim that is granted or renewed
    bool is_new = false;      ///< the token is to be stored before anybody learns of it
  };

  /// `newest_token`: of the last claim that was ever granted, 0 if none was.
  Claims(std::uint64_t newest_token, Clock::duration lease) : token_(newest_token), lease_(lease) {}

  /// Renews the claim if `token` is that of the claim in force and `asker` has it (whose request was repeated, too);
  /// grants a new one if nobody's is in force. `asker` isn't 0.
  Answer claim(std::uint64_t asker, std::uint64_t token, Clock::time_point now);

  /// Ends the claim of that token; one that is over already is no fault.
  Answer release(std::uint64_t asker, std::uint64_t token, Clock::time_point now);

  /// Whether `token` is that of the claim in force.
  bool holds(std::uint64_t token, Clock::time_point now) const { return in_force(now) && token == token_; }
  bool in_force(Clock::time_point now) const { return holder_ != 0 && now < until_; }

  /// A command under the claim in force is a sign of life, too.
  void renew(Clock::time_point now) { until_ = now + lease_; }

  /// Ends the claim in force.
  void revoke() { holder_ = 0; }

  std::uint64_t newest_token() const { return token_; }
  /// 0: nobody.
  std::uint64_t holder(Clock::time_point now) const { return in_force(now) ? holder_ : 0; }
  Clock::duration lease() const { return lease_; }

 private:
  std::uint64_t token_;
  Clock::duration lease_;
  std::uint64_t holder_ = 0;
  Clock::time_point until_{};
};

}  // namespace lamprey::robot_bridge
