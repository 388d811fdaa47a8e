#pragma once

#include "messaging/port.hpp"

#include <cstdint>
#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/rtps/common/Locator.h>
#include <string>

namespace lamprey::messaging::fastdds {

/// Port 0 stands for the well-known ports of all participants of a host, address 0.0.0.0 for all of this host's.
eprosima::fastrtps::rtps::Locator_t locator(const std::string& address, std::uint16_t port = 0);

/// The participant's settings: the user's default profile (FASTRTPS_DEFAULT_PROFILES_FILE) with ours on top; transports
/// of the user's own are left as they are, unless the options limit the program to some interfaces, which are given by
/// their addresses. Also switches off, for the process, delivery that bypasses the network.
/// Throws std::runtime_error on a peer or a discovery server that has no IPv4 address.
eprosima::fastdds::dds::DomainParticipantQos participant_qos(const JoinOptions& options);

}  // namespace lamprey::messaging::fastdds
