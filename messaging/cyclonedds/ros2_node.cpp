#include "messaging/cyclonedds/ros2_node.hpp"

#include "messaging/cyclonedds/domain.hpp"
#include "messaging/cyclonedds/endpoints.hpp"
#include "messaging/cyclonedds/entity.hpp"
#include "messaging/cyclonedds/participant_qos.hpp"
#include "messaging/malformed_samples.hpp"
#include "messaging/participant_of.hpp"

#include <dds/dds.h>
#include <string>
#include <utility>

namespace lamprey::messaging::cyclonedds {
namespace {

class CycloneNode final
    : public Overrides<CycloneNode, ros2::Node, ros2::JointState, ros2::Diagnostics, ros2::JointCommand> {
 public:
  explicit CycloneNode(const JoinOptions& options)
      : domain_(make_domain(options, KeyHashes::omitted)),
        participant_(dds_create_participant(number_of(domain_), make_participant_qos(options).get(), nullptr),
                     "participant") {}

  template <class Message>
  std::unique_ptr<Writer<Message>> open_writer(Partition) {
    return std::make_unique<CycloneWriter<Message>>(participant_.get(), default_partition_,
                                                    counters_.of(Topic<Message>::name));
  }
  template <class Message>
  std::unique_ptr<Reader<Message>> open_reader(Partition, std::shared_ptr<Signal> signal) {
    return std::make_unique<CycloneReader<Message>>(participant_.get(), default_partition_, std::move(signal),
                                                    malformed_, counters_.of(Topic<Message>::name));
  }
  std::uint64_t malformed_samples() const override { return malformed_->count(); }

 private:
  const std::string default_partition_;
  TrafficCounters counters_;
  std::shared_ptr<MalformedSamples> malformed_ = std::make_shared<MalformedSamples>();
  Entity domain_;
  Entity participant_;
};

}  // namespace

std::unique_ptr<ros2::Node> make_ros2_node(const JoinOptions& options) {
  return std::make_unique<CycloneNode>(options);
}

}  // namespace lamprey::messaging::cyclonedds
