#include "messaging/fastdds/ros2_node.hpp"

#include "messaging/fastdds/configuration.hpp"
#include "messaging/fastdds/endpoints.hpp"
#include "messaging/fastdds/entity.hpp"
#include "messaging/malformed_samples.hpp"
#include "messaging/participant_of.hpp"

#include <fastdds/rtps/common/WriteParams.h>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>

namespace lamprey::messaging::fastdds {
namespace {

/// Fast DDS 2.9 announces a participant with write parameters that it has shared and changed since the first one of the
/// process: the announcement then says that it answers that one's. This is allowed, but clients that don't expect any
/// parameters there can't read it.
dds::DomainParticipant* create_participant(const JoinOptions& options) {
  const auto qos = participant_qos(options);
  using eprosima::fastrtps::rtps::WriteParams;
  WriteParams::WRITE_PARAM_DEFAULT = WriteParams();
  return dds::DomainParticipantFactory::get_instance()->create_participant(options.domain, qos);
}

template <class Message>
struct Registered {
  Owned<dds::Topic> topic;
};

class FastNode final : public Overrides<FastNode, ros2::Node, ros2::JointState, ros2::Diagnostics, ros2::JointCommand> {
 public:
  explicit FastNode(const JoinOptions& options)
      : participant_(own(create_participant(options), "a participant for ROS 2")) {}

  template <class Message>
  std::unique_ptr<Writer<Message>> open_writer(Partition) {
    return std::make_unique<FastWriter<Message>>(*participant_, topic<Message>(), default_partition_,
                                                 counters_.of(Topic<Message>::name));
  }
  template <class Message>
  std::unique_ptr<Reader<Message>> open_reader(Partition, std::shared_ptr<Signal> signal) {
    return std::make_unique<FastReader<Message>>(*participant_, topic<Message>(), default_partition_, std::move(signal),
                                                 malformed_, counters_.of(Topic<Message>::name));
  }
  std::uint64_t malformed_samples() const override { return malformed_->count(); }

 private:
  template <class Message>
  dds::Topic& topic() {
    const std::lock_guard lock(mutex_);
    auto& topic = std::get<Registered<Message>>(topics_).topic;
    if (topic == nullptr) topic = make_topic<Message>(*participant_, malformed_);
    return *topic;
  }

  const std::string default_partition_;
  TrafficCounters counters_;
  std::shared_ptr<MalformedSamples> malformed_ = std::make_shared<MalformedSamples>();
  Owned<dds::DomainParticipant> participant_;
  std::mutex mutex_;
  std::tuple<Registered<ros2::JointState>, Registered<ros2::Diagnostics>, Registered<ros2::JointCommand>> topics_;
};

}  // namespace

std::unique_ptr<ros2::Node> make_ros2_node(const JoinOptions& options) {
  return std::make_unique<FastNode>(options);
}

}  // namespace lamprey::messaging::fastdds
