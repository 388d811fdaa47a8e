#pragma once

#include "coordinator/directed_writers.hpp"
#include "coordinator/ledger.hpp"
#include "coordinator/open_sweep.hpp"
#include "idl/client.pb.h"
#include "messaging/fragmentation.hpp"
#include "messaging/port.hpp"
#include "storage/results_reader.hpp"
#include "storage/results_store.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace lamprey::coordinator {

struct CoordinatorOptions {
  LedgerOptions ledger;
  Clock::duration commit_interval = std::chrono::milliseconds{50};  ///< group commit: results wait at most this long
  std::size_t commit_bytes = std::size_t{8} << 20;                  ///< … or until this much has come together
  Clock::duration progress_interval = std::chrono::milliseconds{500};
  Clock::duration specification_interval = std::chrono::seconds{2};  ///< between repeats of the open specifications
  Clock::duration storage_retry = std::chrono::seconds{1};           ///< after the disk was full
};

/// A sweep's life from submission to its last row: takes samples from the port, decides by the ledger, stores, and only
/// then acknowledges. One thread; time comes in as an argument, so that tests own it.
class Coordinator {
 public:
  /// Goes on with every unfinished sweep of the store.
  Coordinator(messaging::Participant& participant, storage::ResultsStore store,
              std::shared_ptr<messaging::Signal> signal, CoordinatorOptions options, Clock::time_point now);

  /// Handles everything that has arrived, commits what is due, grants leases, reports progress. Throws StorageError
  /// if the database fails in a way that waiting does not mend.
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
  void open(const storage::Sweep& stored, bool publish);
  void take_statuses(Clock::time_point now);
  void expire(Clock::time_point now);
  void grant(Clock::time_point now);
  void publish_progress(Clock::time_point now);
  void publish_specification(const OpenSweep& sweep, bool open);
  void repeat_specifications(Clock::time_point now);
  void watch_log_size(Clock::time_point now);
  void look_for_newer_epoch(const messaging::WorkerStatus& status);
  void cancel_some();
  void commit(Clock::time_point now);
  void after_commit(Clock::time_point now);
  void close_ended_sweeps(Clock::time_point now);
  void quarantine(const QuarantinedJob& job);
  void event(std::string kind, std::uint64_t worker, std::string text, std::optional<std::int64_t> sweep = std::nullopt,
             std::optional<std::uint64_t> job = std::nullopt);
  messaging::Origin origin(std::uint64_t worker = 0) const;
  void send(std::uint64_t worker, messaging::Lease lease);

  // results.cpp: results in, acknowledgements out
  void take_results(Clock::time_point now);
  void take_result(const messaging::Origin& origin, const Id128& sweep, messaging::JobResult result);
  void answer_known(OpenSweep* sweep, std::int64_t row, const messaging::Origin& origin, const Id128& id,
                    const messaging::JobResult& result);
  bool must_agree(const OpenSweep* sweep, const Id128& id, std::uint64_t job, std::uint64_t worker,
                  std::uint64_t other) const;
  std::optional<std::string> build_of(std::uint64_t worker) const;
  void refuse(const messaging::Origin& origin, const Id128& sweep, const messaging::JobResult& result,
              const std::string& reason);
  void acknowledge(const std::vector<StagedAnswer>& answers);

  // requests.cpp: the client's wishes
  void take_requests(Clock::time_point now);
  idl::Reply handle(const idl::Request& request, Clock::time_point now);
  idl::Reply submit(const idl::SubmitRequest& request, Clock::time_point now);
  idl::Reply status(const idl::StatusRequest& request);
  idl::Reply cancel(const idl::CancelRequest& request, Clock::time_point now);
  idl::Reply results(const idl::ResultsRequest& request);
  idl::Reply stored_job(const idl::StoredJobRequest& request);
  storage::ResultsReader& reader();
  idl::SweepStatus status_of(const storage::Sweep& sweep) const;
  std::optional<storage::Sweep> find_sweep(const std::string& name_or_id) const;
  messaging::SweepProgress progress(const OpenSweep& sweep) const;

  messaging::Participant& participant_;
  storage::ResultsStore store_;
  CoordinatorOptions options_;
  Ledger ledger_;
  std::map<Id128, OpenSweep> sweeps_;
  std::map<Id128, std::int64_t> ended_sweeps_;  ///< id → row: a late result of an ended sweep still gets its answer

  std::unique_ptr<messaging::Reader<messaging::WorkerStatus>> statuses_;
  std::unique_ptr<messaging::Reader<messaging::ResultBatch>> results_;
  std::unique_ptr<messaging::Reader<messaging::Request>> requests_;
  std::unique_ptr<messaging::Writer<messaging::SweepSpecification>> specifications_;
  std::unique_ptr<messaging::Writer<messaging::SweepProgress>> progress_;
  DirectedWriters<messaging::Lease> leases_;
  DirectedWriters<messaging::ResultAcknowledgement> acknowledgements_;
  DirectedWriters<messaging::Reply> replies_;

  messaging::Assembler assembler_;
  storage::Batch batch_;
  std::vector<StagedAnswer> answers_;
  std::map<std::pair<Id128, std::uint64_t>, storage::ResultsStore::StoredJob> staged_;  ///< by sweep and job
  std::size_t staged_bytes_ = 0;
  Clock::time_point staged_since_;
  Clock::time_point retry_storage_at_;
  bool storage_failed_ = false;
  Clock::time_point progress_due_;
  Clock::time_point specifications_due_;
  Clock::time_point log_size_due_;
  Clock::time_point last_step_;
  std::string database_path_;  ///< absolute
  bool log_is_large_ = false;
  bool said_newer_epoch_ = false;
  Id128 last_repeated_;
  std::unique_ptr<storage::ResultsReader> reader_;
};

}  // namespace lamprey::coordinator
