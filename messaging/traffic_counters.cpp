#include "messaging/traffic_counters.hpp"

#include <algorithm>

namespace lamprey::messaging {

TopicCounters& TrafficCounters::of(std::string_view topic) {
  const std::scoped_lock lock(mutex_);
  const auto known = std::ranges::find(topics_, topic, &TopicCounters::topic);
  return known != topics_.end() ? *known : topics_.emplace_back(topic);
}

Traffic TrafficCounters::so_far(const std::array<std::uint8_t, 16>& participant, std::uint64_t malformed) const {
  Traffic traffic{.participant = participant,
                  .seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - joined_).count(),
                  .malformed = malformed,
                  .topics = {}};
  const std::scoped_lock lock(mutex_);
  for (const auto& counters : topics_) traffic.topics.push_back(counters.so_far());
  return traffic;
}

}  // namespace lamprey::messaging
