#include "messaging/cyclonedds/discovery_watch.hpp"

#include "messaging/cyclonedds/builtin_topics.hpp"
#include "messaging/cyclonedds/domain.hpp"
#include "messaging/cyclonedds/endpoints.hpp"
#include "messaging/cyclonedds/entity.hpp"
#include "messaging/cyclonedds/participant_qos.hpp"
#include "messaging/discovery/newest_traffic.hpp"
#include "messaging/malformed_samples.hpp"
#include "messaging/names.hpp"
#include "messaging/traffic_counters.hpp"

#include <dds/dds.h>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace lamprey::messaging::cyclonedds {
namespace {

using discovery::Endpoint;
using discovery::Guid;

class CycloneWatch final : public discovery::Watch {
 public:
  explicit CycloneWatch(const JoinOptions& options)
      : domain_(make_domain(options)),
        participant_(dds_create_participant(number_of(domain_), make_participant_qos(options).get(), nullptr),
                     "participant"),
        own_(guid_of(participant_.get())),
        census_(participant_.get()),
        publications_(reader_of(DDS_BUILTIN_TOPIC_DCPSPUBLICATION, "writers")),
        subscriptions_(reader_of(DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION, "readers")),
        traffic_(participant_.get(), std::string(common_partition_of_all), nullptr, malformed_,
                 counters_.of(Topic<Traffic>::name)) {}

  discovery::DomainView look() override {
    discovery::DomainView view;
    view.participants = census_.participants();
    take_endpoints(publications_.get(), true);
    take_endpoints(subscriptions_.get(), false);
    for (const auto& [guid, endpoint] : known_endpoints_) view.endpoints.push_back(endpoint);
    view.traffic = newest_.after(traffic_.take(maximum_untaken));
    return view;
  }

 private:
  Entity reader_of(dds_entity_t topic, const std::string& what) {
    return {dds_create_reader(participant_.get(), topic, nullptr, nullptr), "reader of the domain's " + what};
  }

  void take_endpoints(dds_entity_t reader, bool writes) {
    take_all<dds_builtintopic_endpoint_t>(
        reader,
        [&](const auto& sample) {
          if (guid_of(sample.participant_key) != own_)
            known_endpoints_[guid_of(sample.key)] = converted(sample, writes);
        },
        [this](const auto& sample) { known_endpoints_.erase(guid_of(sample.key)); });
  }

  std::shared_ptr<MalformedSamples> malformed_ = std::make_shared<MalformedSamples>();
  TrafficCounters counters_;
  discovery::NewestTraffic newest_;
  Entity domain_;
  Entity participant_;
  Guid own_;
  Census census_;
  Entity publications_;
  Entity subscriptions_;
  CycloneReader<Traffic> traffic_;
  std::map<Guid, Endpoint> known_endpoints_;
};

}  // namespace

std::unique_ptr<discovery::Watch> make_discovery_watch(const JoinOptions& options) {
  return std::make_unique<CycloneWatch>(options);
}

}  // namespace lamprey::messaging::cyclonedds
