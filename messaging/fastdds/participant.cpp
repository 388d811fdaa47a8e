#include "messaging/fastdds/participant.hpp"

#include "messaging/fastdds/census.hpp"
#include "messaging/fastdds/configuration.hpp"
#include "messaging/fastdds/endpoints.hpp"
#include "messaging/fastdds/entity.hpp"
#include "messaging/malformed_samples.hpp"
#include "messaging/names.hpp"
#include "messaging/participant_of.hpp"
#include "messaging/tuning.hpp"

#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>

namespace lamprey::messaging::fastdds {
namespace {

/// A topic as the participant knows it: once, however many writers and readers it has.
template <class Sample>
struct Registered {
  Owned<dds::Topic> topic;
};

class FastParticipant final : public ParticipantOf<FastParticipant> {
 public:
  explicit FastParticipant(const JoinOptions& options)
      : isolation_(options.isolation),
        participant_(own(dds::DomainParticipantFactory::get_instance()->create_participant(
                             options.domain, participant_qos(options), &census_, dds::StatusMask::none()),
                         "a participant (is the network up, and are there fewer than " +
                             std::to_string(participants_per_host) + " programs of this domain on the host?)")) {}

  template <class Sample>
  std::unique_ptr<Writer<Sample>> open_writer(Partition partition) {
    return std::make_unique<FastWriter<Sample>>(*participant_, topic<Sample>(), partition_name(isolation_, partition),
                                                counters_.of(Topic<Sample>::name));
  }
  template <class Sample>
  std::unique_ptr<Reader<Sample>> open_reader(Partition partition, std::shared_ptr<Signal> signal) {
    return std::make_unique<FastReader<Sample>>(*participant_, topic<Sample>(), partition_name(isolation_, partition),
                                                std::move(signal), malformed_, counters_.of(Topic<Sample>::name));
  }
  std::string vendor() const override { return "fastdds"; }
  std::uint64_t malformed_samples() const override { return malformed_->count(); }
  Traffic traffic() const override { return counters_.so_far(guid_of(participant_->guid()), malformed_samples()); }
  std::vector<discovery::Participant> others() override { return census_.participants(); }

 private:
  template <class Sample>
  dds::Topic& topic() {
    const std::lock_guard lock(mutex_);
    auto& registered = std::get<Registered<Sample>>(topics_);
    if (registered.topic == nullptr) {
      registered.topic = make_topic<Sample>(*participant_, malformed_);
    }
    return *registered.topic;
  }

  std::string isolation_;
  TrafficCounters counters_;
  ParticipantCensus census_;  ///< listens until the participant is gone
  std::shared_ptr<MalformedSamples> malformed_ = std::make_shared<MalformedSamples>();
  Owned<dds::DomainParticipant> participant_;
  std::mutex mutex_;
  std::tuple<Registered<WorkerStatus>, Registered<SweepSpecification>, Registered<Lease>, Registered<ResultBatch>,
             Registered<ResultAcknowledgement>, Registered<Checkpoint>, Registered<Request>, Registered<Reply>,
             Registered<SweepProgress>, Registered<Traffic>, Registered<RobotStatus>, Registered<RobotRequest>,
             Registered<RobotReply>, Registered<ServoCommand>, Registered<ServoState>>
      topics_;
};

}  // namespace

std::unique_ptr<Participant> make_participant(const JoinOptions& options) {
  return std::make_unique<FastParticipant>(options);
}

}  // namespace lamprey::messaging::fastdds
