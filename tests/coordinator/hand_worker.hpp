#pragma once

#include "tests/coordinator/site.hpp"

#include <cstdint>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace lamprey::tests {

/// A worker by hand: writes what the test wants, collects what it is answered.
class HandWorker {
 public:
  HandWorker(Site& site, std::uint64_t incarnation)
      : site_(site),
        incarnation_(incarnation),
        participant_(site.bus.join("hand")),
        status_(participant_->writer<messaging::WorkerStatus>()),
        results_(participant_->writer<messaging::ResultBatch>()),
        leases_(participant_->reader<messaging::Lease>(signal_, messaging::Partition::of(incarnation))),
        acknowledgements_(
            participant_->reader<messaging::ResultAcknowledgement>(signal_, messaging::Partition::of(incarnation))) {}

  std::uint32_t science_version = experiment::science_version;
  std::string host = "hand";
  std::string build;

  std::vector<messaging::Lease> heartbeat(std::vector<messaging::HeldLease> held = {}) {
    messaging::WorkerStatus status;
    status.origin = {{}, 0, incarnation_, science_version};
    status.heartbeat = ++heartbeats_;
    status.threads = 1;
    status.window = 2;
    status.host = host;
    status.build = build;
    status.leases = std::move(held);
    EXPECT_TRUE(static_cast<bool>(status_->write(status)));
    site_.advance(std::chrono::milliseconds{100});
    return leases_->take();
  }

  std::vector<messaging::Acknowledgement> send(const messaging::Origin& origin, const experiment::Id128& sweep,
                                               const messaging::JobResult& result) {
    messaging::ResultBatch batch;
    batch.origin = origin;
    batch.origin.worker = incarnation_;
    batch.sweep = sweep;
    batch.results = {result};
    EXPECT_TRUE(static_cast<bool>(results_->write(batch)));
    site_.advance(std::chrono::milliseconds{200});
    std::vector<messaging::Acknowledgement> answers;
    for (const auto& sample : acknowledgements_->take()) {
      answers.insert(answers.end(), sample.results.begin(), sample.results.end());
    }
    return answers;
  }

 private:
  Site& site_;
  std::uint64_t incarnation_;
  std::uint64_t heartbeats_ = 0;
  std::shared_ptr<messaging::Signal> signal_ = std::make_shared<messaging::Signal>();
  std::unique_ptr<messaging::Participant> participant_;
  std::unique_ptr<messaging::Writer<messaging::WorkerStatus>> status_;
  std::unique_ptr<messaging::Writer<messaging::ResultBatch>> results_;
  std::unique_ptr<messaging::Reader<messaging::Lease>> leases_;
  std::unique_ptr<messaging::Reader<messaging::ResultAcknowledgement>> acknowledgements_;
};

inline messaging::JobResult computed(const experiment::SweepGrid& grid, std::uint64_t number) {
  const std::vector<experiment::Job> job{grid.job(number)};
  auto result = experiment::make_scalar_engine()->run(job, {}).front();
  messaging::JobResult message;
  message.job = number;
  message.identity = result.identity;
  message.outcome = std::get<experiment::Outcome>(std::move(result.result));
  message.digest = experiment::outcome_digest(message.identity, message.outcome);
  return message;
}

}  // namespace lamprey::tests
