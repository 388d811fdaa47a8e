#include "messaging/fastdds/discovery_watch.hpp"

#include "messaging/discovery/newest_traffic.hpp"
#include "messaging/fastdds/census.hpp"
#include "messaging/fastdds/configuration.hpp"
#include "messaging/fastdds/endpoints.hpp"
#include "messaging/fastdds/entity.hpp"
#include "messaging/malformed_samples.hpp"
#include "messaging/names.hpp"
#include "messaging/traffic_counters.hpp"

#include <memory>
#include <string>

namespace lamprey::messaging::fastdds {
namespace {

/// Who asks a discovery server is told of those only that it would exchange something with.
dds::DomainParticipantQos watching_qos(const JoinOptions& options) {
  auto qos = participant_qos(options);
  auto& protocol = qos.wire_protocol().builtin.discovery_config.discoveryProtocol;
  using Protocol = eprosima::fastrtps::rtps::DiscoveryProtocol;
  if (protocol == Protocol::CLIENT) protocol = Protocol::SUPER_CLIENT;
  return qos;
}

class FastWatch final : public discovery::Watch {
 public:
  explicit FastWatch(const JoinOptions& options)
      : participant_(own(dds::DomainParticipantFactory::get_instance()->create_participant(
                             options.domain, watching_qos(options), &census_, dds::StatusMask::none()),
                         "a participant that watches the domain")),
        topic_(make_topic<Traffic>(*participant_, malformed_)),
        traffic_(*participant_, *topic_, std::string(common_partition_of_all), nullptr, malformed_,
                 counters_.of(Topic<Traffic>::name)) {}

  discovery::DomainView look() override {
    auto view = census_.view();
    view.traffic = newest_.after(traffic_.take(maximum_untaken));
    return view;
  }

 private:
  std::shared_ptr<MalformedSamples> malformed_ = std::make_shared<MalformedSamples>();
  TrafficCounters counters_;
  discovery::NewestTraffic newest_;
  DomainCensus census_;
  Owned<dds::DomainParticipant> participant_;  // destroyed before the census: afterwards nobody calls it
  Owned<dds::Topic> topic_;
  FastReader<Traffic> traffic_;
};

}  // namespace

std::unique_ptr<discovery::Watch> make_discovery_watch(const JoinOptions& options) {
  return std::make_unique<FastWatch>(options);
}

}  // namespace lamprey::messaging::fastdds
