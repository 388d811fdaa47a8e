#pragma once

#include "messaging/port.hpp"

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>

namespace lamprey::messaging::fastdds {

/// The participant's settings: the user's default profile (FASTRTPS_DEFAULT_PROFILES_FILE) with ours on top; transports
/// of the user's own are left as they are. Also switches off, for the process, delivery that bypasses the network.
/// Throws std::runtime_error on a peer that has no IPv4 address.
eprosima::fastdds::dds::DomainParticipantQos participant_qos(const JoinOptions& options);

}  // namespace lamprey::messaging::fastdds
