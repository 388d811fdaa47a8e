#pragma once

#include "messaging/port.hpp"

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace lamprey::robot_bridge {

/// Where the requests for one robot come in and their answers go out, over one membership of the domain. Remembers the
/// last answer of each asker, for a request that comes again. One thread.
class RequestDoor {
 public:
  RequestDoor(messaging::Participant& participant, std::shared_ptr<messaging::Signal> signal, std::uint64_t robot);
  RequestDoor(const RequestDoor&) = delete;
  RequestDoor& operator=(const RequestDoor&) = delete;

  /// Those for this robot that have come since the last call.
  std::vector<messaging::RobotRequest> take();

  /// Whether the request has been answered before: then it is again, in the same words.
  bool answer_again(const messaging::RobotRequest& request);

  /// An answer that can't be written is asked for again.
  void answer(messaging::RobotReply reply);

  /// Requests that named another robot, or nobody who asks.
  std::uint64_t strays() const { return strays_; }

 private:
  struct Asker {
    std::uint64_t number = 0;
    std::unique_ptr<messaging::Writer<messaging::RobotReply>> writer;
    messaging::RobotReply last;
  };
  std::deque<Asker>::iterator find(std::uint64_t asker);

  messaging::Participant& participant_;
  std::uint64_t robot_;
  std::unique_ptr<messaging::Reader<messaging::RobotRequest>> requests_;
  std::deque<Asker> askers_;  ///< the newest last; few
  std::uint64_t strays_ = 0;
};

}  // namespace lamprey::robot_bridge
