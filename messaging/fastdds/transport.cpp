#include "messaging/fastdds/transport.hpp"

#include <fastdds/rtps/common/LocatorsIterator.hpp>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <set>
#include <utility>

namespace lamprey::messaging::fastdds {
namespace {

namespace rtps = eprosima::fastdds::rtps;
using eprosima::fastrtps::rtps::Locator_t;
using eprosima::fastrtps::rtps::LocatorList_t;
using eprosima::fastrtps::rtps::octet;
using eprosima::fastrtps::rtps::SenderResource;

constexpr std::uint32_t largest_datagram = 65'500;

/// Fast DDS holds its lock on sender resources around both sending and opening, so this needs none of its own.
class AnnouncingTransport final : public rtps::ChainingTransport {
 public:
  using rtps::ChainingTransport::ChainingTransport;

  bool OpenOutputChannel(rtps::SendResourceList& resources, const Locator_t& locator) override {
    announced_.insert(locator);
    return ChainingTransport::OpenOutputChannel(resources, locator);
  }

  /// What is sent is limited by the descriptor's `maxMessageSize`; what comes from others may be larger.
  bool OpenInputChannel(const Locator_t& locator, rtps::TransportReceiverInterface* receiver, std::uint32_t) override {
    return ChainingTransport::OpenInputChannel(locator, receiver, largest_datagram);
  }

  bool send(SenderResource* udp, const octet* buffer, std::uint32_t size, rtps::LocatorsIterator* begin,
            rtps::LocatorsIterator* end, const std::chrono::steady_clock::time_point& timeout) override {
    bool sent = true;
    for (; *begin != *end; ++*begin) {
      LocatorList_t one;
      one.push_back(**begin);
      if (low_level_transport_->IsLocatorSupported(**begin) && announced_.insert(**begin).second) {
        low_level_transport_->OpenOutputChannel(own_resources_, **begin);
      }
      eprosima::fastrtps::rtps::Locators first(one.begin());
      eprosima::fastrtps::rtps::Locators last(one.end());
      sent &= udp->send(buffer, size, &first, &last, timeout);
    }
    return sent;
  }

  void receive(rtps::TransportReceiverInterface* receiver, const octet* buffer, std::uint32_t size,
               const Locator_t& local, const Locator_t& remote) override {
    receiver->OnDataReceived(buffer, size, local, remote);
  }

  rtps::TransportDescriptorInterface* get_configuration() override { return low_level_transport_->get_configuration(); }

 private:
  std::set<Locator_t> announced_;
  rtps::SendResourceList own_resources_;
};

struct AnnouncingDescriptor final : rtps::ChainingTransportDescriptor {
  using rtps::ChainingTransportDescriptor::ChainingTransportDescriptor;
  rtps::TransportInterface* create_transport() const override { return new AnnouncingTransport(*this); }
};

}  // namespace

std::shared_ptr<rtps::TransportDescriptorInterface> announcing(std::shared_ptr<rtps::UDPv4TransportDescriptor> udp) {
  return std::make_shared<AnnouncingDescriptor>(std::move(udp));
}

}  // namespace lamprey::messaging::fastdds
