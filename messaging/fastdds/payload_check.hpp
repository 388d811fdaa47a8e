#pragma once

#include "messaging/samples.hpp"

#include <cstdint>
#include <span>

namespace lamprey::messaging::fastdds {

/// Whether every string and sequence in a serialised sample (XCDR1: 4 bytes of encapsulation, then plain CDR of the
/// type in idl/lamprey.idl) can be as long as it says it is: its elements end within the payload. Allocates nothing.
template <class Sample>
bool lengths_are_possible(std::span<const std::uint8_t> payload);

template <>
bool lengths_are_possible<WorkerStatus>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<SweepSpecification>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<Lease>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<ResultBatch>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<ResultAcknowledgement>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<Request>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<Reply>(std::span<const std::uint8_t> payload);
template <>
bool lengths_are_possible<SweepProgress>(std::span<const std::uint8_t> payload);

}  // namespace lamprey::messaging::fastdds
