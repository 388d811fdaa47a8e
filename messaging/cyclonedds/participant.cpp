#include "messaging/cyclonedds/participant.hpp"

#include "messaging/cyclonedds/builtin_topics.hpp"
#include "messaging/cyclonedds/domain.hpp"
#include "messaging/cyclonedds/endpoints.hpp"
#include "messaging/cyclonedds/entity.hpp"
#include "messaging/cyclonedds/participant_qos.hpp"
#include "messaging/malformed_samples.hpp"
#include "messaging/names.hpp"
#include "messaging/participant_of.hpp"

#include <dds/dds.h>
#include <optional>
#include <string>
#include <utility>

namespace lamprey::messaging::cyclonedds {
namespace {

class CycloneParticipant final : public ParticipantOf<CycloneParticipant> {
 public:
  explicit CycloneParticipant(const JoinOptions& options)
      : isolation_(options.isolation),
        domain_(make_domain(options)),
        participant_(dds_create_participant(number_of(domain_), make_participant_qos(options).get(), nullptr),
                     "participant") {}

  template <class Sample>
  std::unique_ptr<Writer<Sample>> open_writer(Partition partition) {
    return std::make_unique<CycloneWriter<Sample>>(participant_.get(), partition_name(isolation_, partition),
                                                   counters_.of(Topic<Sample>::name));
  }
  template <class Sample>
  std::unique_ptr<Reader<Sample>> open_reader(Partition partition, std::shared_ptr<Signal> signal) {
    return std::make_unique<CycloneReader<Sample>>(participant_.get(), partition_name(isolation_, partition),
                                                   std::move(signal), malformed_, counters_.of(Topic<Sample>::name));
  }
  std::string vendor() const override { return "cyclonedds"; }
  std::uint64_t malformed_samples() const override { return malformed_->count(); }
  Traffic traffic() const override { return counters_.so_far(guid_of(participant_.get()), malformed_samples()); }
  std::vector<discovery::Participant> others() override {
    if (!census_) census_.emplace(participant_.get());
    return census_->participants();
  }

 private:
  TrafficCounters counters_;
  std::shared_ptr<MalformedSamples> malformed_ = std::make_shared<MalformedSamples>();
  std::string isolation_;
  Entity domain_;
  Entity participant_;
  std::optional<Census> census_;  ///< from when somebody asks
};

}  // namespace

std::unique_ptr<Participant> make_participant(const JoinOptions& options) {
  return std::make_unique<CycloneParticipant>(options);
}

}  // namespace lamprey::messaging::cyclonedds
