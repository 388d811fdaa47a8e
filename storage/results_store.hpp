#pragma once

#include "experiment/identifiers.hpp"
#include "experiment/job_ranges.hpp"
#include "experiment/outcome.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// The SQLite results database. docs/formats/database.md describes every table, view and column; so does the database
/// itself (schema_description).
namespace lamprey::storage {

/// What can go wrong with a database; what() names the file and the reason.
class StorageError : public std::runtime_error {
 public:
  enum class Kind : std::uint8_t {
    missing,         ///< no such file
    not_a_database,  ///< a file of another kind, or another application's database
    newer_schema,    ///< written by a later Lamprey
    older_schema,    ///< written by an earlier one; a coordinator that opens it brings it up to date
    other_science,   ///< written under another science version
    in_use,          ///< another coordinator holds it
    network_file_system,
    name_taken,  ///< a different sweep of that name exists
    corrupt,
    full,          ///< no space left
    busy,          ///< somebody else writes it at this moment; passes
    input_output,  ///< anything else that SQLite or the system reports
  };
  StorageError(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

enum class SweepState : std::uint8_t { running, finished, cancelling, cancelled };
enum class JobState : std::uint8_t { done, failed, quarantined, cancelled };
std::string to_text(SweepState state);
std::string to_text(JobState state);

struct JobCounts {
  std::uint64_t done = 0;
  std::uint64_t failed = 0;
  std::uint64_t quarantined = 0;
  std::uint64_t cancelled = 0;

  std::uint64_t ended() const { return done + failed + quarantined + cancelled; }
  bool operator==(const JobCounts&) const = default;
};

struct NewSweep {
  experiment::Id128 id;
  std::string name;
  std::string specification;  ///< idl::SweepSpecification, serialized
  std::string source;         ///< the sweep file's text; may be empty
  std::uint64_t seed = 0;
  std::uint32_t replicates = 1;
  std::uint64_t jobs = 0;
};

struct Sweep {
  std::int64_t row = 0;  ///< key in the database
  NewSweep what;
  std::uint32_t science_version = 0;
  SweepState state = SweepState::running;
  JobCounts counts;
  std::uint64_t divergences = 0;
  std::int64_t created_unix_milliseconds = 0;
  std::optional<std::int64_t> ended_unix_milliseconds;
};

/// Who computed; one row per incarnation.
struct Worker {
  std::uint64_t incarnation = 0;
  std::string host;
  std::uint32_t process = 0;
  std::uint32_t threads = 0;
  std::string build;
  std::string dds;
};

/// A job that has ended. identity, digest and outcome are set for `done`; identity alone or nothing else.
struct EndedJob {
  std::int64_t sweep = 0;  ///< Sweep::row
  std::uint64_t job = 0;
  JobState state = JobState::done;
  std::optional<experiment::Digest> identity;
  std::optional<experiment::Digest> digest;
  std::string parameters;  ///< experiment::to_json; empty for `cancelled`
  std::uint64_t seed = 0;
  std::uint32_t replicate = 0;
  std::optional<experiment::Outcome> outcome;
  double seconds = 0;
  std::uint64_t worker = 0;  ///< incarnation; 0: none
  std::uint32_t attempt = 1;
  std::string reason;  ///< why failed or quarantined
};

struct Divergence {
  std::int64_t sweep = 0;
  std::uint64_t job = 0;
  experiment::Digest stored{};
  experiment::Digest other{};
  std::uint64_t worker = 0;
};

/// One line of the sweep's history: kind is a snake_case noun such as sweep_submitted, worker_joined, lease_lost.
struct Event {
  std::string kind;
  std::optional<std::int64_t> sweep;
  std::optional<std::uint64_t> job;
  std::uint64_t worker = 0;
  std::string text;
};

/// Everything that one transaction writes.
struct Batch {
  std::vector<Worker> workers = {};  ///< inserted or brought up to date
  std::vector<EndedJob> jobs = {};
  std::vector<Divergence> divergences = {};
  std::vector<Event> events = {};
  struct StateChange {
    std::int64_t sweep = 0;
    SweepState state = SweepState::running;
  };
  std::vector<StateChange> states = {};

  bool empty() const {
    return workers.empty() && jobs.empty() && divergences.empty() && events.empty() && states.empty();
  }
};

struct StoreOptions {
  std::string vfs;  ///< name of the SQLite VFS; empty: the default one. For tests that lose power.
};

/// The one writer of a database. Not thread-safe. Every function throws StorageError.
/// When a function that writes has returned, what it wrote survives a power cut (synchronous=FULL).
class ResultsStore {
 public:
  /// Opens the database or makes a new one; migrates an older schema; refuses what StorageError::Kind lists; holds an
  /// exclusive lock against other coordinators until destroyed (also released by the death of the process); raises
  /// the epoch.
  explicit ResultsStore(const std::string& path, const StoreOptions& options = {});
  ~ResultsStore();
  ResultsStore(ResultsStore&&) noexcept;
  ResultsStore& operator=(ResultsStore&&) noexcept;

  const std::string& path() const;
  experiment::Id128 database_id() const;
  std::uint64_t epoch() const;

  /// What opening had to bring up to date; empty if nothing. Also an event, schema_migrated.
  const std::string& migration() const;

  /// In order of submission.
  std::vector<Sweep> sweeps() const;

  /// Stores a new sweep in one transaction that costs the same for any number of jobs. If a sweep of that id exists
  /// (same specification, same science version) it is returned instead and `existed` set. Throws name_taken if another
  /// sweep has the name.
  struct Added {
    Sweep sweep;
    bool existed = false;
  };
  Added add_sweep(const NewSweep& sweep);

  /// Numbers of the jobs that have a row.
  experiment::JobRanges ended_jobs(std::int64_t sweep) const;

  /// State, digest and worker of a job that has a row (the digest is absent for states without one).
  struct StoredJob {
    JobState state = JobState::done;
    std::optional<experiment::Digest> digest;
    std::uint64_t worker = 0;  ///< incarnation; 0: none
  };
  std::optional<StoredJob> find_job(std::int64_t sweep, std::uint64_t job) const;

  /// The build that the worker reported; nothing if the worker has no row.
  std::optional<std::string> build_of(std::uint64_t worker) const;

  /// Writes the batch in one transaction and brings the sweeps' counters up to date in it. A sweep whose last job ends
  /// becomes finished (or cancelled, if it was cancelling) in the same transaction. All or nothing: after an exception
  /// none of it is stored and the same batch may be committed again. The jobs must not have rows yet.
  void commit(const Batch& batch);

  /// Size of the write-ahead log in bytes, and whether a reader's open transaction kept it from being reset when a
  /// commit last tried, which it does once the log is larger than 16 MiB.
  struct LogSize {
    std::uint64_t bytes = 0;
    bool held_by_reader = false;
  };
  LogSize log_size() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace lamprey::storage
