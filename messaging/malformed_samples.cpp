#include "messaging/malformed_samples.hpp"

#include <spdlog/spdlog.h>

namespace lamprey::messaging {

void MalformedSamples::note(std::string_view topic, const std::string& source, const std::string& reason) {
  const std::scoped_lock lock(mutex_);
  ++count_;
  if (reported_.size() >= most_sources || !reported_.emplace(topic, source).second) return;
  spdlog::warn("a malformed sample of {} from {} is dropped, and so is every other one of it: {}", topic, source,
               reason);
}

std::uint64_t MalformedSamples::count() const {
  const std::scoped_lock lock(mutex_);
  return count_;
}

}  // namespace lamprey::messaging
