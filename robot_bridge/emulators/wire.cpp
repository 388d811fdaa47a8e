#include "robot_bridge/emulators/wire.hpp"

#include <algorithm>

namespace lamprey::robot_bridge::emulators {
namespace {

constexpr std::int64_t bits_per_octet = 10;
constexpr std::int64_t nanoseconds_per_second = 1'000'000'000;
constexpr Time group = std::chrono::milliseconds{1};

}  // namespace

void Wire::send(std::span<const std::uint8_t> octets, Time start, Time gap) {
  const Time begin = std::max(start, free_at_);
  std::int64_t count = 0;
  for (const std::uint8_t octet : octets) {
    const Time pauses = count * gap;
    ++count;
    // From the beginning of the group, so that parts of a nanosecond do not add up.
    free_at_ = begin + Time{count * bits_per_octet * nanoseconds_per_second / baud_} + pauses;
    octets_.push_back({octet, free_at_});
  }
}

std::vector<Wire::Octet> Wire::take(Time now) {
  const auto end = std::ranges::find_if(octets_, [now](const Octet& octet) { return octet.time > now; });
  std::vector<Octet> arrived(octets_.begin(), end);
  octets_.erase(octets_.begin(), end);
  return arrived;
}

std::optional<Time> Wire::next() const {
  if (octets_.empty()) return std::nullopt;
  const Time limit = octets_.front().time + group;
  const auto end = std::ranges::find_if(octets_, [limit](const Octet& octet) { return octet.time > limit; });
  return std::prev(end)->time;
}

void Wire::clear() {
  octets_.clear();
  free_at_ = Time::min();
}

}  // namespace lamprey::robot_bridge::emulators
