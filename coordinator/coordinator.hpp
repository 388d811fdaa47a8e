#pragma once

#include "coordinator/audit.hpp"
#include "coordinator/directed_writers.hpp"
#include "coordinator/journal.hpp"
#include "coordinator/ledger.hpp"
#include "coordinator/metrics.hpp"
#include "coordinator/open_sweep.hpp"
#include "coordinator/robot_watch.hpp"
#include "idl/client.pb.h"
#include "messaging/fragmentation.hpp"
#include "messaging/port.hpp"
#include "storage/results_reader.hpp"
#include "storage/results_store.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lamprey::coordinator {

struct CoordinatorOptions {
  LedgerOptions ledger;
  JournalOptions journal;
  Clock::duration progress_interval = std::chrono::milliseconds{500};
  Clock::duration specification_interval = std::chrono::seconds{2};  ///< between repeats of the open specifications
  /// The same while a worker has just joined: it has missed those before, and DDS may take a moment to reach it.
  Clock::duration newcomers_interval = std::chrono::milliseconds{100};
};

/// A sweep's life from submission to its last row: takes samples from the port, decides by the ledger, stores by the
/// journal, and only then acknowledges. One thread; time comes in as an argument, so that tests own it.
class Coordinator {
 public:
  /// Goes on with every unfinished sweep of the store. `robots`: where robots are heard of, if not by `participant`.
  Coordinator(messaging::Participant& participant, storage::ResultsStore store,
              std::shared_ptr<messaging::Signal> signal, CoordinatorOptions options, Clock::time_point now,
              messaging::Participant* robots = nullptr);

  /// Handles everything that has arrived, commits what is due, grants leases, reports progress. A database that fails
  /// ends nothing: what has come in waits until it works again.
  void step(Clock::time_point now);

  /// Commits what has come in and says goodbye in the event log.
  void finish(Clock::time_point now);

 private:
  struct StagedAnswer {
    std::uint64_t worker = 0;
    messaging::Acknowledgement acknowledgement;
    std::uint64_t lease = 0;
    double seconds = -1;
  };

  // coordinator.cpp: life
  void open(const storage::Sweep& stored);
  void go_on(const storage::Sweep& stored);
  void guard(Clock::time_point now, const std::function<void()>& work);
  void work_in_background(Clock::time_point now);
  void cancel_some(OpenSweep& sweep, Clock::time_point now);
  void reuse_some(OpenSweep& sweep, Clock::time_point now);
  void delete_some(OpenSweep& sweep);
  void commit(Clock::time_point now);
  void after_commit(const storage::Batch& batch, Clock::time_point now);
  void note_stops(const storage::Batch& batch);
  void stop_early(Clock::time_point now);
  void close_ended_sweeps(Clock::time_point now);
  messaging::Origin origin(std::uint64_t worker = 0) const;

  // workers.cpp: who is here and holds what
  void take_statuses(Clock::time_point now);
  void take_status(messaging::WorkerStatus status, Clock::time_point now);
  void greet(const messaging::WorkerStatus& status, Clock::time_point now);
  void look_for_newer_epoch(const messaging::WorkerStatus& status);
  void take_robot_statuses(Clock::time_point now);
  void note(const std::vector<RobotEvent>& events);
  void expire(Clock::time_point now);
  void close_writers(std::uint64_t worker);
  void close_writers_of_the_silent(Clock::time_point now);
  void quarantine(const QuarantinedJob& job, Clock::time_point now);
  void note(const FailedAttempt& attempt);
  void grant(Clock::time_point now);
  void send(std::uint64_t worker, messaging::Lease lease);
  void revoke(std::vector<messaging::Lease> leases);

  // publishing.cpp: what anyone may see
  void publish_progress(Clock::time_point now);
  void publish_specification(const storage::Sweep& sweep, const Id128& id, bool open);
  void repeat_specifications(Clock::time_point now);
  void watch_log_size(Clock::time_point now);
  messaging::SweepProgress progress(const OpenSweep& sweep) const;

  // results.cpp: results in, acknowledgements out
  void take_results(Clock::time_point now);
  void take_result(const messaging::Origin& origin, const Id128& sweep, messaging::JobResult result,
                   Clock::time_point now);
  void answer_known(OpenSweep* sweep, std::int64_t row, const messaging::Origin& origin, const Id128& id,
                    const messaging::JobResult& result, Clock::time_point now);
  void answer_divergence(const std::string& sweep, std::int64_t row, const experiment::Digest& stored,
                         const messaging::Origin& origin, const messaging::JobResult& result,
                         messaging::Acknowledgement& answer);
  bool must_agree(const OpenSweep* sweep, const Id128& id, std::uint64_t job, std::uint64_t worker,
                  std::uint64_t other) const;
  std::optional<std::string> build_of(std::uint64_t worker) const;
  void refuse(const messaging::Origin& origin, const Id128& sweep, const messaging::JobResult& result,
              const std::string& reason, Clock::time_point now);
  void acknowledge(const std::vector<StagedAnswer>& answers);
  void take_checkpoints();
  void take_checkpoint(messaging::Checkpoint checkpoint);

  // audits.cpp: done jobs, computed again by others
  void open_audit(const storage::Audit& stored);
  void take_audit_result(OpenAudit& audit, const messaging::Origin& origin, const messaging::JobResult& result,
                         Clock::time_point now);
  void end_audited_job(OpenAudit& audit, std::uint64_t job, std::uint64_t worker, const experiment::Digest& digest,
                       bool agreed);
  void close_ended_audits();
  idl::Reply audit(const idl::AuditRequest& request);
  idl::Reply audit_status(const idl::AuditStatusRequest& request);
  idl::AuditStatus status_of(const storage::Audit& audit) const;

  // requests.cpp: what a client asks, and submitting
  void take_requests(Clock::time_point now);
  idl::Reply answer(const messaging::Request& sample, Clock::time_point now);
  idl::Reply handle(const idl::Request& request, Clock::time_point now);
  idl::Reply submit(const idl::SubmitRequest& request, Clock::time_point now);
  std::optional<storage::Sweep> find_sweep(const std::string& name_or_id) const;
  idl::Reply changed(const storage::Sweep& stored, const idl::SweepSpecification& given) const;
  idl::Reply unknown_sweep(const std::string& wanted) const;

  // control.cpp: what a person wishes
  idl::Reply cancel(const idl::CancelRequest& request, Clock::time_point now);
  void begin_cancelling(OpenSweep& sweep, const std::string& reason);
  idl::Reply control(const idl::ControlRequest& request, Clock::time_point now);
  idl::Reply pause(const storage::Sweep& sweep);
  idl::Reply resume(const storage::Sweep& sweep, const idl::ControlRequest& request);
  idl::Reply retry(const storage::Sweep& sweep, bool cancelled_too, Clock::time_point now);
  idl::Reply archive(const storage::Sweep& sweep, bool archived);
  idl::Reply remove(const storage::Sweep& sweep);
  idl::Reply rename(const idl::RenameRequest& request);
  idl::Reply adjust(const idl::AdjustRequest& request);
  idl::Reply drain(const idl::DrainRequest& request, Clock::time_point now);
  idl::Reply control_reply(const Id128& sweep, std::uint64_t jobs) const;
  bool commit_now(Clock::time_point now);

  // looking.cpp: what a client wants to see
  idl::Reply status(const idl::StatusRequest& request, Clock::time_point now);
  idl::SweepStatus status_of(const storage::Sweep& sweep) const;
  void add_worker(idl::StatusReply& status, const Ledger::WorkerView& view, Clock::time_point now) const;
  idl::Reply results(const idl::ResultsRequest& request);
  idl::Reply stored_job(const idl::StoredJobRequest& request);
  idl::Reply trace(const idl::TraceRequest& request);
  idl::Reply events(const idl::EventsRequest& request);
  idl::Reply metrics();
  std::string name_of(const Id128& sweep) const;
  storage::ResultsReader& reader();

  messaging::Participant& participant_;
  std::shared_ptr<messaging::Signal> signal_;
  CoordinatorOptions options_;
  Journal journal_;
  Ledger ledger_;
  RobotWatch robots_;
  Counters counters_;
  std::map<Id128, OpenSweep> sweeps_;
  std::map<Id128, std::int64_t> ended_sweeps_;  ///< id → row: a late result of an ended sweep still gets its answer
  std::map<Id128, OpenAudit> audits_;           ///< that are not finished
  std::map<Id128, std::string> to_stop_;        ///< sweeps that are to end early, and why

  std::unique_ptr<messaging::Reader<messaging::WorkerStatus>> statuses_;
  std::unique_ptr<messaging::Reader<messaging::RobotStatus>> robot_statuses_;
  std::unique_ptr<messaging::Reader<messaging::ResultBatch>> results_;
  std::unique_ptr<messaging::Reader<messaging::Checkpoint>> checkpoints_;
  std::unique_ptr<messaging::Reader<messaging::Request>> requests_;
  std::unique_ptr<messaging::Writer<messaging::SweepSpecification>> specifications_;
  std::unique_ptr<messaging::Writer<messaging::SweepProgress>> progress_;
  DirectedWriters<messaging::Lease> leases_;
  DirectedWriters<messaging::ResultAcknowledgement> acknowledgements_;
  DirectedWriters<messaging::Reply> replies_;

  messaging::Assembler assembler_;
  std::vector<StagedAnswer> answers_;
  std::deque<std::pair<Clock::time_point, std::uint64_t>> silent_;  ///< workers, and until when their writers are kept
  Clock::time_point progress_due_;
  Clock::time_point specifications_due_;
  Clock::time_point newcomers_until_;  ///< so long somebody may need every specification at once
  Clock::time_point log_size_due_;
  Clock::time_point last_step_;
  std::string database_path_;  ///< absolute
  bool log_is_large_ = false;
  bool said_newer_epoch_ = false;
  Id128 last_repeated_;
  std::unique_ptr<storage::ResultsReader> reader_;
};

}  // namespace lamprey::coordinator
