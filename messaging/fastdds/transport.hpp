#pragma once

#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <memory>

namespace lamprey::messaging::fastdds {

/// UDP that may be sent to an address that has not been announced to it. Fast DDS 2.9 sends the first heartbeat to a
/// newly found reader before it opens the channel to it; its statistics module, which Debian's library has with its
/// assertions, then ends the program.
std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface> announcing(
    std::shared_ptr<eprosima::fastdds::rtps::UDPv4TransportDescriptor> udp);

}  // namespace lamprey::messaging::fastdds
