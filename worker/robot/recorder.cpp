#include "worker/robot/recorder.hpp"

#include "experiment/problem.hpp"
#include "idl/recording.pb.h"

#include <cmath>

namespace lamprey::worker {
namespace {

/// Beyond any robot's positions; a bridge that says more says nothing.
constexpr double furthest = 1000;

std::int32_t hundredths(double position) {
  return std::isfinite(position) && std::abs(position) <= furthest
             ? static_cast<std::int32_t>(std::lround(100 * position))
             : 0;
}

}  // namespace

Recorder::Recorder(const std::string& robot, std::uint64_t token)
    : recording_(std::make_unique<idl::RobotRecording>()) {
  recording_->set_robot(robot);
  recording_->set_token(token);
}

Recorder::~Recorder() = default;

void Recorder::begin() {
  auto& now = *recording_->add_evaluations();
  now.set_evaluation(evaluation_);
  now.set_attempt(attempt_);
}

void Recorder::add(const messaging::ServoState& state) {
  auto& now = *recording_->mutable_evaluations()->rbegin();
  for (const double position : state.commanded) now.add_commanded(hundredths(position));
  for (const double position : state.reported) now.add_reported(hundredths(position));
  now.add_feet_down(state.feet_down);
  now.set_measured(state.measured);
}

void Recorder::accept() {
  ++evaluation_;
  attempt_ = 0;
}

void Recorder::reject(const std::string& reason) {
  // It came from the network; and an empty one would say that the try counts.
  recording_->mutable_evaluations()->rbegin()->set_voided(reason.empty() ? "no reason given"
                                                                         : experiment::printable(reason));
  ++attempt_;
}

std::vector<std::uint8_t> Recorder::octets() const {
  const std::string text = recording_->SerializeAsString();
  return {text.begin(), text.end()};
}

}  // namespace lamprey::worker
