#include "tests/client/scripted_coordinator.hpp"

#include <gtest/gtest.h>
#include <set>
#include <utility>

namespace lamprey::tests {

ScriptedCoordinator::ScriptedCoordinator(Site& site, Answer answer)
    : site_(site),
      answer_(std::move(answer)),
      participant_(site.bus.join("coordinator")),
      progress_(participant_->writer<messaging::SweepProgress>()),
      thread_([this] { serve(); }) {}

ScriptedCoordinator::~ScriptedCoordinator() {
  stop_ = true;
  thread_.join();
}

std::vector<idl::Request> ScriptedCoordinator::requests() const {
  const std::lock_guard lock(mutex_);
  return requests_;
}

void ScriptedCoordinator::publish(const messaging::SweepProgress& progress) {
  auto sample = progress;
  sample.origin.database = database;
  ASSERT_TRUE(progress_->write(sample));
}

void ScriptedCoordinator::serve() {
  const auto signal = std::make_shared<messaging::Signal>();
  const auto reader = participant_->reader<messaging::Request>(signal);
  std::set<std::pair<std::uint64_t, std::uint64_t>> answered;
  while (!stop_) {
    for (const auto& sample : reader->take()) {
      if (!answered.emplace(sample.client, sample.correlation).second) continue;
      idl::Request request;
      request.ParseFromArray(sample.payload.data(), static_cast<int>(sample.payload.size()));
      const auto bytes = answer_(request).SerializeAsString();
      {
        const std::lock_guard lock(mutex_);
        requests_.push_back(request);
      }
      messaging::Reply reply;
      reply.origin.database = database;
      reply.client = sample.client;
      reply.correlation = sample.correlation;
      reply.payload.assign(bytes.begin(), bytes.end());
      EXPECT_TRUE(participant_->writer<messaging::Reply>(messaging::Partition::of(sample.client))->write(reply));
    }
    signal->wait_for(std::chrono::milliseconds{2});
  }
}

idl::Reply error_reply(const std::string& code, const std::vector<std::string>& messages) {
  idl::Reply reply;
  reply.mutable_error()->set_code(code);
  for (const auto& message : messages) reply.mutable_error()->add_messages(message);
  return reply;
}

}  // namespace lamprey::tests
