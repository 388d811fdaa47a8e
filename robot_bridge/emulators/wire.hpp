#pragma once

#include "robot_bridge/emulators/time.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace lamprey::robot_bridge::emulators {

/// One direction of a serial line: a pseudo-terminal has no pace of its own, so each octet is held back until its stop
/// bit would have come: ten bits an octet, one octet after the other.
class Wire {
 public:
  struct Octet {
    std::uint8_t value;
    Time time;  ///< when its stop bit has come
  };

  /// `baud` is positive.
  explicit Wire(unsigned baud) : baud_(baud) {}

  /// Sends octets from `start` on, or from when the wire is free, with a pause of `gap` between each two of them.
  void send(std::span<const std::uint8_t> octets, Time start, Time gap = Time::zero());

  /// What has arrived by `now`, in order; it is no longer on the wire then.
  std::vector<Octet> take(Time now);

  /// When it is worth while to take again: at the end of the next millisecond's octets, so that nobody has to wake for
  /// each of them. Nothing, if the wire is empty.
  std::optional<Time> next() const;

  /// When all that was sent will have arrived.
  Time free_at() const { return free_at_; }
  std::size_t waiting() const { return octets_.size(); }
  /// Whatever is on the way is lost.
  void clear();

 private:
  unsigned baud_;
  Time free_at_ = Time::min();
  std::deque<Octet> octets_;
};

}  // namespace lamprey::robot_bridge::emulators
