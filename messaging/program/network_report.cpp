#include "messaging/program/network_report.hpp"

#include "messaging/discovery/version_skew.hpp"

#include <spdlog/spdlog.h>
#include <utility>

namespace lamprey::messaging::program {

NetworkReport::NetworkReport(Participant& participant, const JoinOptions& own)
    : participant_(participant), own_(introduction_of(own)), traffic_(participant.writer<Traffic>()) {}

void NetworkReport::step(Clock::time_point now) {
  if (now >= traffic_due_) {
    traffic_due_ = now + traffic_interval;
    // Nobody's work depends on it, and the next one says the same: a write that fails is counted, and that is all.
    static_cast<void>(traffic_->write(participant_.traffic()));
  }
  if (now >= look_due_) {
    look_due_ = now + look_interval;
    look();
  }
}

void NetworkReport::look() {
  for (const auto& skew : discovery::version_skew(participant_.others(), own_)) {
    auto text = discovery::to_text(skew, own_);
    if (told_.size() >= most_warnings || told_.contains(text)) continue;
    if (skew.meets) {
      spdlog::info("{}", text);
    } else {
      spdlog::warn("{}", text);
    }
    told_.insert(std::move(text));
  }
}

}  // namespace lamprey::messaging::program
