#pragma once

#include "coordinator/ledger.hpp"
#include "storage/results_store.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamprey::coordinator {

struct JournalOptions {
  Clock::duration commit_interval = std::chrono::milliseconds{50};  ///< group commit: what is staged waits at most so
  std::size_t commit_bytes = std::size_t{8} << 20;                  ///< … or until so much has come together
  Clock::duration storage_retry = std::chrono::seconds{1};          ///< after a commit has failed
};

/// What is to be stored, from its staging to its commit. Whatever the database does, nothing that is staged is lost:
/// a commit that fails is tried again, with everything, until it succeeds. Not thread-safe.
class Journal {
 public:
  Journal(storage::ResultsStore store, JournalOptions options, Clock::time_point now);

  storage::ResultsStore& store() { return store_; }
  const storage::ResultsStore& store() const { return store_; }

  /// The batch that the next commit writes, for whatever is not a job's row.
  storage::Batch& batch() { return batch_; }
  void event(std::string kind, std::uint64_t worker, std::string text, std::optional<std::int64_t> sweep = std::nullopt,
             std::optional<std::uint64_t> job = std::nullopt);

  /// `id`: of the row's sweep. `bytes`: what it weighs.
  void add(const Id128& id, storage::EndedJob row, std::size_t bytes, Clock::time_point now);

  /// What a robot recorded; once, however often it is added before a commit. `bytes`: what it weighs.
  void add(storage::RecordedAttempt attempt, std::size_t bytes);
  /// A recording came that can't be kept.
  void note_dropped_recording() { ++counters_.dropped_recordings; }

  /// The row that waits for its commit, if there is one.
  const storage::ResultsStore::StoredJob* staged(const Id128& sweep, std::uint64_t job) const;

  /// The next commit does not wait for company.
  void hurry() { hurried_ = true; }

  /// Commits if that is due; what has been committed, or nothing. Throws nothing: see fault().
  std::optional<storage::Batch> commit(Clock::time_point now);

  /// Whether there is nothing to commit.
  bool empty() const { return batch_.empty(); }

  /// Why nothing can be stored at this moment; empty if all is well.
  const std::string& fault() const { return fault_; }
  bool healthy() const { return fault_.empty(); }
  /// The database has failed outside a commit. It counts as healthy again after the next commit, which is certain to
  /// come.
  void note_fault(const storage::StorageError& error, Clock::time_point now);

  struct Counters {
    std::uint64_t commits = 0;
    std::uint64_t faults = 0;
    std::uint64_t dropped_events = 0;      ///< more than fit while nothing could be stored
    std::uint64_t dropped_recordings = 0;  ///< of robots, that came with results
    double seconds = 0;                    ///< of all commits
    double longest_seconds = 0;
  };
  const Counters& counters() const { return counters_; }

 private:
  storage::ResultsStore store_;
  JournalOptions options_;
  storage::Batch batch_;
  std::vector<Clock::time_point> arrivals_;  ///< of batch_.jobs
  std::map<std::pair<Id128, std::uint64_t>, storage::ResultsStore::StoredJob> staged_;
  std::size_t staged_bytes_ = 0;
  Clock::time_point staged_since_;
  Clock::time_point retry_at_;
  bool hurried_ = false;
  std::string fault_;
  Counters counters_;
};

}  // namespace lamprey::coordinator
