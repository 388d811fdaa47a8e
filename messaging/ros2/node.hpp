#pragma once

#include "messaging/port.hpp"
#include "messaging/ros2/messages.hpp"

#include <memory>
#include <type_traits>
#include <utility>

namespace lamprey::messaging::ros2 {

/// A program's membership of a ROS 2 domain: to ROS 2's tools its endpoints look like those of a node, without ROS 2.
/// The message's type names the topic (topics.hpp). As messaging::Participant otherwise: writers and readers must be
/// destroyed before it; they throw std::runtime_error with the vendor's reason where they can't be made.
class Node : public TopicPorts<JointState, Diagnostics, JointCommand> {
 public:
  template <class Message>
  std::unique_ptr<Writer<Message>> writer() {
    return this->make_writer(std::type_identity<Message>{}, Partition::common());
  }
  template <class Message>
  std::unique_ptr<Reader<Message>> reader(std::shared_ptr<Signal> signal) {
    return this->make_reader(std::type_identity<Message>{}, Partition::common(), std::move(signal));
  }

  /// Messages that its readers have dropped because they can't be what they claim to be. Any thread.
  virtual std::uint64_t malformed_samples() const = 0;
};

/// Joins options.domain with the vendor's own library, over UDP. ROS 2 knows no isolation: of `options` it is of no
/// meaning here. Throws JoinError as messaging::join does.
std::unique_ptr<Node> join(const JoinOptions& options);

}  // namespace lamprey::messaging::ros2
