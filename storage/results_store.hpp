#pragma once

#include "experiment/identifiers.hpp"
#include "experiment/job_ranges.hpp"
#include "experiment/outcome.hpp"
#include "storage/recording.hpp"

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
    name_taken,    ///< a different sweep of that name exists
    not_possible,  ///< not of a sweep in this state
    corrupt,
    full,          ///< no space left
    busy,          ///< somebody else writes it at this moment; passes
    read_only,     ///< the file, or the file system that it is on, cannot be written
    input_output,  ///< anything else that SQLite or the system reports
  };
  StorageError(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

/// paused and running change into each other; deleting ends with the row itself.
enum class SweepState : std::uint8_t { running, paused, finished, cancelling, cancelled, deleting };
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
  std::string execution = {};  ///< idl::Execution, serialized; may change
  bool fresh = false;          ///< outcomes that the database has are computed again all the same
};

struct Sweep {
  std::int64_t row = 0;  ///< key in the database
  NewSweep what;
  std::uint32_t science_version = 0;
  SweepState state = SweepState::running;
  JobCounts counts;
  std::uint64_t divergences = 0;
  std::uint64_t reused = 0;   ///< of done: copied from another sweep's row of the same identity
  std::uint64_t audited = 0;  ///< jobs that an audit has computed again
  bool archived = false;
  std::string reason;  ///< why it was stopped, where that was not a person's wish
  std::int64_t created_unix_milliseconds = 0;
  std::optional<std::int64_t> ended_unix_milliseconds;
};

/// Who computed; one row per incarnation.
struct Worker {
  std::uint64_t incarnation = 0;
  std::string host;
  std::uint32_t process = 0;
  std::uint32_t threads = 0;
  std::string build;       ///< version and commit
  std::string flags = {};  ///< compiler and flags of the build
  std::string processor = {};
  std::string instruction_set = {};
  std::string dds;
  std::string labels = {};  ///< between commas
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
  std::string reason;         ///< why failed or quarantined
  double queue_seconds = 0;   ///< from submission, or from being pending again, to the lease that it was computed under
  double waited_seconds = 0;  ///< at the worker, before its computation began
  double commit_seconds = 0;  ///< from the arrival of its result to the beginning of the commit
  struct Source {
    std::int64_t sweep = 0;
    std::uint64_t job = 0;
  };
  std::optional<Source> reused_from;  ///< whose outcome it is, where it was not computed for this sweep
};

/// An attempt at a job that has not led to its row: the worker was lost with it, its result was refused, or the row was
/// taken back by a retry.
struct Attempt {
  std::int64_t sweep = 0;
  std::uint64_t job = 0;
  std::uint64_t worker = 0;
  std::string end;       ///< lost, refused, failed, quarantined, cancelled
  bool counted = false;  ///< towards quarantine
  std::string reason;
};

/// What a robot did in one attempt of a job. Stored once, however often it comes: see Batch::recordings.
struct RecordedAttempt {
  std::int64_t sweep = 0;
  std::uint64_t job = 0;
  std::uint64_t worker = 0;
  JobState state = JobState::done;  ///< that the attempt ended in: done or failed
  bool accepted = false;            ///< its outcome is the job's row
  RobotRecording recording;         ///< that recording_fault finds nothing in
  bool operator==(const RecordedAttempt&) const = default;
};

/// Attempts of a job that are kept beside the accepted one; what comes beyond is ignored.
inline constexpr std::uint64_t most_other_recordings = 100;

/// Where a job that has no row yet can go on; the newest of a job replaces the one before.
struct Checkpoint {
  std::int64_t sweep = 0;
  std::uint64_t job = 0;
  std::uint64_t worker = 0;
  std::uint32_t cycle = 0;
  double seconds = 0;  ///< of computation so far
  std::string state;   ///< experiment/checkpoint.hpp
};

/// Some of a sweep's done jobs are computed again by other workers and their digests compared.
struct Audit {
  std::int64_t row = 0;
  experiment::Id128 id;
  std::int64_t sweep = 0;
  double share = 0;        ///< of the jobs that were done and bitwise repeatable when it began
  std::uint64_t seed = 0;  ///< which ones: coordinator/audit_sample.hpp
  std::uint64_t jobs = 0;
  std::uint64_t agreed = 0;
  std::uint64_t diverged = 0;
  bool finished() const { return agreed + diverged == jobs; }
};
struct AuditedJob {
  std::int64_t audit = 0;
  std::uint64_t job = 0;
  std::uint64_t worker = 0;
  experiment::Digest digest{};
  bool agreed = false;
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
    std::string reason = {};
  };
  std::vector<StateChange> states = {};
  std::vector<Attempt> attempts = {};
  std::vector<Checkpoint> checkpoints = {};  ///< of a job that has a row, or gets one in this batch: ignored
  std::vector<AuditedJob> audited = {};      ///< also counted in the audit's and the sweep's row
  std::vector<RecordedAttempt> recordings =
      {};  ///< one that is stored already, or of a sweep that is gone or going: ignored

  bool empty() const {
    return workers.empty() && jobs.empty() && divergences.empty() && events.empty() && states.empty() &&
           attempts.empty() && checkpoints.empty() && audited.empty() && recordings.empty();
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

  // ---- what people wish; each in one transaction, with its event ----

  /// Another name; throws name_taken. The id stays.
  void rename(std::int64_t sweep, const std::string& name);
  void set_archived(std::int64_t sweep, bool archived);
  void set_execution(std::int64_t sweep, const std::string& execution);

  /// Takes back the rows of failed and quarantined jobs (`cancelled_too`: also of cancelled ones): they become attempts
  /// with their reasons, which no longer count towards quarantine, and the sweep runs again, unless it is paused. What
  /// robots recorded in them stays.
  /// Throws not_possible while it is cancelling or deleting. Returns which jobs; empty if there were none, and then
  /// nothing has changed.
  experiment::JobRanges retry(std::int64_t sweep, bool cancelled_too);

  /// Deletes up to `most` of the rows of a sweep in state deleting, and at last its own; whether nothing is left.
  /// Events stay, with its name in their text.
  bool delete_some(std::int64_t sweep, std::uint64_t most);

  /// Workers that have been told to drain and have not left since. Throws not_possible if a worker without a row is to
  /// drain.
  void set_draining(std::uint64_t worker, bool draining);
  std::vector<std::uint64_t> draining() const;

  // ---- what a restart needs ----

  /// Counted attempts of jobs without a row.
  struct CountedAttempts {
    std::uint64_t job = 0;
    std::vector<std::uint64_t> workers;
  };
  std::vector<CountedAttempts> counted_attempts(std::int64_t sweep) const;
  std::vector<std::uint64_t> checkpointed_jobs(std::int64_t sweep) const;
  std::optional<Checkpoint> find_checkpoint(std::int64_t sweep, std::uint64_t job) const;

  // ---- reuse and audit ----

  /// Outcomes of done jobs of other sweeps with the same seed: at most `most` after the place of the last one, in order
  /// of sweep and job. Begin with {}.
  struct Place {
    std::int64_t sweep = 0;
    std::uint64_t job = 0;
    bool begun = false;
  };
  struct StoredIdentity {
    Place place;
    experiment::Digest identity{};
  };
  std::vector<StoredIdentity> identities(std::uint64_t seed, std::int64_t but_of_sweep, const Place& after,
                                         std::uint64_t most) const;
  /// A job's row as it is stored; nothing if it has none or is malformed.
  std::optional<EndedJob> read_job(std::int64_t sweep, std::uint64_t job) const;

  /// Numbers of the done jobs.
  experiment::JobRanges done_jobs(std::int64_t sweep) const;
  /// `row`, counts are set here; the same id twice gives the stored one.
  Audit add_audit(const Audit& audit);
  std::vector<Audit> audits() const;
  experiment::JobRanges audited_jobs(std::int64_t audit) const;

  // ---- looking back ----

  struct StoredEvent {
    std::int64_t number = 0;
    std::int64_t unix_milliseconds = 0;
    Event event;
  };
  /// With numbers above `after`, oldest first, at most `most`; `after` 0: the newest `most`. `sweep`: of that one only.
  std::vector<StoredEvent> events(std::optional<std::int64_t> sweep, std::int64_t after, std::uint64_t most) const;

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
