#pragma once

#include "messaging/ros2/messages.hpp"
#include "messaging/samples.hpp"

#include <cstdint>
#include <span>

namespace lamprey::messaging::fastdds {

/// Whether every string and sequence in a serialised sample (XCDR1: 4 bytes of encapsulation, then plain CDR of the
/// type in idl/*.idl) can be as long as it says it is: its elements end within the payload. Allocates nothing. There is
/// none for batches of results, which check while they read (result_batch_type.hpp).
template <class Sample>
bool lengths_are_possible(std::span<const std::uint8_t> payload);

template <>
bool lengths_are_possible<WorkerStatus>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<SweepSpecification>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<Lease>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<ResultAcknowledgement>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<Checkpoint>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<Request>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<Reply>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<SweepProgress>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<Traffic>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<RobotStatus>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<RobotRequest>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<RobotReply>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<ServoCommand>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<ServoState>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<ros2::JointState>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<ros2::Diagnostics>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<ros2::JointCommand>(std::span<const std::uint8_t> payload);

}  // namespace lamprey::messaging::fastdds
