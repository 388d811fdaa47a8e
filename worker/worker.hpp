#pragma once

#include "experiment/sweep.hpp"
#include "messaging/port.hpp"
#include "worker/job_executor.hpp"
#include "worker/lease_book.hpp"
#include "worker/outbox.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lamprey::worker {

struct WorkerOptions {
  std::uint64_t incarnation = 0;  ///< random, not 0; names this run of this worker
  std::string host;
  std::uint32_t process = 0;
  std::string build;
  std::string flags;
  std::string processor;
  std::string instruction_set;
  std::vector<std::string> labels;
  Clock::duration heartbeat = std::chrono::milliseconds{500};
  std::uint32_t leases_per_thread = 2;  ///< one computed, one waiting
  OutboxOptions outbox;
};

/// Leases in, results out. Keeps what it holds and what it has computed while there is no coordinator. One thread; time
/// comes in as an argument.
class Worker {
 public:
  Worker(messaging::Participant& participant, JobExecutor& executor, std::shared_ptr<messaging::Signal> signal,
         WorkerOptions options, Clock::time_point now);

  /// Handles everything that has arrived, keeps the executor busy, sends what is due.
  void step(Clock::time_point now);

  /// Stops computing and gives unfinished leases back. Call step() until settled() (or patience ends), then goodbye().
  void begin_leaving(Clock::time_point now);
  bool settled() const { return outbox_.held() == 0; }

  /// It has been told to drain and has nothing left to do: time to leave.
  bool drained() const { return draining_ && book_.empty() && outbox_.held() == 0 && executor_.idle(); }

  void goodbye(Clock::time_point now);

  std::uint64_t jobs_done() const { return jobs_done_; }
  std::size_t results_held() const { return outbox_.held(); }

 private:
  struct KnownCoordinator {
    std::uint64_t epoch = 0;
    std::uint64_t last_lease_sequence = 0;
  };

  /// What it has counted since it started; told with each heartbeat.
  struct Counters {
    std::uint64_t leases_taken = 0;
    std::uint64_t leases_ignored = 0;  ///< repeated, unusable, for another worker or of an older epoch
    std::uint64_t leases_revoked = 0;
    std::uint64_t results_refused = 0;
    std::uint64_t results_divergent = 0;
    std::uint64_t results_duplicate = 0;
    std::uint64_t checkpoints_sent = 0;
    std::uint64_t specifications_refused = 0;
  };

  bool current(const messaging::Origin& origin);
  void take_lease(const messaging::Lease& lease);
  void revoke(const messaging::Lease& lease);
  void note(const messaging::Acknowledgement& answer);
  void send_checkpoints();
  void send_checkpoint(messaging::Checkpoint checkpoint);
  void take_specifications();
  void take_leases();
  void take_acknowledgements();
  void take_finished(Clock::time_point now);
  void choose_jobs();
  void start_jobs();
  void cannot_compute(const messaging::SweepSpecification& sample, const std::string& reason);
  void send_results(Clock::time_point now);
  void send_status(Clock::time_point now);
  messaging::WorkerStatus status() const;

  messaging::Participant& participant_;
  JobExecutor& executor_;
  WorkerOptions options_;
  std::string vendor_;
  std::unique_ptr<messaging::Reader<messaging::SweepSpecification>> specifications_;
  std::unique_ptr<messaging::Reader<messaging::Lease>> leases_;
  std::unique_ptr<messaging::Reader<messaging::ResultAcknowledgement>> acknowledgements_;
  std::unique_ptr<messaging::Writer<messaging::WorkerStatus>> status_;
  std::unique_ptr<messaging::Writer<messaging::ResultBatch>> results_;
  std::unique_ptr<messaging::Writer<messaging::Checkpoint>> checkpoints_;

  std::map<Id128, KnownCoordinator> coordinators_;                                         ///< by database
  std::map<std::pair<Id128, Id128>, std::shared_ptr<const experiment::SweepGrid>> grids_;  ///< by database and sweep
  std::set<std::pair<Id128, Id128>> unusable_;  ///< sweeps whose specification this version can't read
  std::vector<Task> starting_;                  ///< chosen, and not handed to the executor yet
  LeaseBook book_;
  Outbox outbox_;
  Id128 last_database_;
  Counters counters_;
  std::vector<std::string> offered_;  ///< the executor's labels, as told last
  std::uint64_t heartbeats_ = 0;
  std::uint64_t batches_ = 0;
  std::uint64_t jobs_done_ = 0;
  Clock::time_point status_due_;
  Clock::time_point last_status_;
  bool status_changed_ = true;
  bool draining_ = false;
  bool leaving_ = false;
  bool said_full_ = false;
};

}  // namespace lamprey::worker
