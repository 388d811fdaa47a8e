#include "robot_bridge/request_door.hpp"

#include <algorithm>
#include <exception>
#include <iterator>
#include <spdlog/spdlog.h>
#include <utility>

namespace lamprey::robot_bridge {
namespace {

constexpr std::size_t most_askers = 64;

}  // namespace

RequestDoor::RequestDoor(messaging::Participant& participant, std::shared_ptr<messaging::Signal> signal,
                         std::uint64_t robot)
    : participant_(participant),
      robot_(robot),
      requests_(participant.reader<messaging::RobotRequest>(std::move(signal), messaging::Partition::of(robot))) {}

std::vector<messaging::RobotRequest> RequestDoor::take() {
  auto requests = requests_->take();
  strays_ += std::erase_if(requests, [this](const messaging::RobotRequest& request) {
    return request.robot != robot_ || request.asker == 0;
  });
  return requests;
}

std::deque<RequestDoor::Asker>::iterator RequestDoor::find(std::uint64_t asker) {
  return std::ranges::find(askers_, asker, &Asker::number);
}

bool RequestDoor::answer_again(const messaging::RobotRequest& request) {
  const auto asker = find(request.asker);
  if (asker == askers_.end() || asker->last.correlation != request.correlation) return false;
  static_cast<void>(asker->writer->write(asker->last));
  return true;
}

void RequestDoor::answer(messaging::RobotReply reply) {
  if (const auto asker = find(reply.asker); asker != askers_.end()) {
    // Who still asks is not the first to be forgotten.
    std::rotate(asker, std::next(asker), askers_.end());
  } else {
    try {
      askers_.push_back(
          {reply.asker, participant_.writer<messaging::RobotReply>(messaging::Partition::of(reply.asker)), {}});
    } catch (const std::exception& error) {
      // It asks again.
      spdlog::warn("no answer to {:016x}: {}", reply.asker, error.what());
      return;
    }
    if (askers_.size() > most_askers) askers_.pop_front();
  }
  Asker& newest = askers_.back();
  newest.last = std::move(reply);
  static_cast<void>(newest.writer->write(newest.last));
}

}  // namespace lamprey::robot_bridge
