#include "messaging/ros2/limits.hpp"

#include "messaging/limits.hpp"

#include <string_view>

namespace lamprey::messaging::ros2 {
namespace {

using Violation = std::optional<std::string>;

Violation beyond(std::string_view field, std::size_t size, std::size_t most) {
  if (size <= most) return {};
  return std::string(field) + ": size " + std::to_string(size) + ", at most " + std::to_string(most);
}

}  // namespace

std::optional<std::string> limit_violation(const JointState& message) {
  if (auto found = beyond("frame_id", message.frame.size(), maximum_text_bytes)) return found;
  if (auto found = beyond("name", message.names.size(), maximum_elements)) return found;
  for (const auto& name : message.names) {
    if (auto found = beyond("name", name.size(), maximum_text_bytes)) return found;
  }
  if (auto found = beyond("position", message.positions.size(), maximum_elements)) return found;
  if (auto found = beyond("velocity", message.velocities.size(), maximum_elements)) return found;
  return beyond("effort", message.efforts.size(), maximum_elements);
}

std::optional<std::string> limit_violation(const Diagnostics& message) {
  if (auto found = beyond("frame_id", message.frame.size(), maximum_text_bytes)) return found;
  if (auto found = beyond("status", message.statuses.size(), maximum_elements)) return found;
  for (const auto& status : message.statuses) {
    for (const auto* text : {&status.name, &status.message, &status.hardware}) {
      if (auto found = beyond("status", text->size(), maximum_text_bytes)) return found;
    }
    if (auto found = beyond("status.values", status.values.size(), maximum_elements)) return found;
    for (const auto& [key, value] : status.values) {
      if (auto found = beyond("status.values.key", key.size(), maximum_text_bytes)) return found;
      if (auto found = beyond("status.values.value", value.size(), maximum_text_bytes)) return found;
    }
  }
  return {};
}

std::optional<std::string> limit_violation(const JointCommand& message) {
  return beyond("data", message.positions.size(), maximum_elements);
}

}  // namespace lamprey::messaging::ros2
