#pragma once

#include "storage/recording_writer.hpp"
#include "storage/results_store.hpp"
#include "storage/statement.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace lamprey::storage {

/// Writes batches with statements that are prepared once. The caller holds the transaction; after an exception it must
/// roll back. Throws StorageError. Not thread-safe.
class BatchWriter {
 public:
  BatchWriter(const Connection& connection, std::uint64_t epoch);

  void write(const Batch& batch);
  void write(const Event& event);

 private:
  /// What a batch adds to the counters of one sweep.
  struct Increase {
    JobCounts counts;
    std::uint64_t divergences = 0;
    std::uint64_t reused = 0;
    std::uint64_t audited = 0;
  };
  using Increases = std::map<std::int64_t, Increase>;

  void insert(const Event& event);
  void write(const Worker& worker);
  void write(const EndedJob& job, Increases& increases);
  void write(const Divergence& divergence, Increases& increases);
  void write(const Attempt& attempt);
  void write(const Checkpoint& checkpoint);
  void write(const AuditedJob& job, Increases& increases);
  void write(const Batch::StateChange& change);
  void delete_checkpoint(std::int64_t sweep, std::uint64_t job);
  void update_sweep(std::int64_t sweep, const Increase& increase);

  const Connection& connection_;
  std::uint64_t epoch_;
  std::int64_t now_ = 0;  ///< time of the batch or event being written
  Statement upsert_worker_;
  Statement insert_job_;
  Statement insert_divergence_;
  Statement insert_event_;
  Statement insert_attempt_;
  Statement upsert_checkpoint_;
  Statement delete_checkpoint_;
  Statement insert_audited_;
  Statement count_audited_;
  Statement change_state_;
  Statement add_counts_;
  Statement finish_;
  RecordingWriter recordings_;
  /// Jobs that may have a checkpoint: all that have one, and perhaps some that had. Most jobs never do, and are spared
  /// the search for it.
  std::set<std::pair<std::int64_t, std::uint64_t>> checkpointed_;
  std::string trace_text_;  ///< kept between jobs for its memory
  std::string measures_text_;
};

}  // namespace lamprey::storage
