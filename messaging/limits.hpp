#pragma once

#include "messaging/samples.hpp"

#include <cstddef>
#include <optional>
#include <string>

/// Bounds of what may be in one sample. A vendor checks both ways: a write beyond them fails and says so, a sample that
/// arrives beyond them is dropped as hostile.
namespace lamprey::messaging {

inline constexpr std::size_t maximum_text_bytes = 64 * 1024;
inline constexpr std::size_t maximum_elements = 1024 * 1024;
inline constexpr std::size_t maximum_labels = 64;
inline constexpr std::size_t maximum_counters = 256;
inline constexpr std::size_t maximum_payload_bytes = 16 * 1024 * 1024;

/// What is beyond its bound, as "field: value, at most bound"; nothing if all is well.
std::optional<std::string> limit_violation(const WorkerStatus& sample);
std::optional<std::string> limit_violation(const SweepSpecification& sample);
std::optional<std::string> limit_violation(const Lease& sample);
std::optional<std::string> limit_violation(const ResultBatch& sample);
std::optional<std::string> limit_violation(const ResultAcknowledgement& sample);
std::optional<std::string> limit_violation(const Checkpoint& sample);
std::optional<std::string> limit_violation(const Request& sample);
std::optional<std::string> limit_violation(const Reply& sample);
std::optional<std::string> limit_violation(const SweepProgress& sample);
std::optional<std::string> limit_violation(const Traffic& sample);
std::optional<std::string> limit_violation(const RobotStatus& sample);
std::optional<std::string> limit_violation(const RobotRequest& sample);
std::optional<std::string> limit_violation(const RobotReply& sample);
std::optional<std::string> limit_violation(const ServoCommand& sample);
std::optional<std::string> limit_violation(const ServoState& sample);

}  // namespace lamprey::messaging
