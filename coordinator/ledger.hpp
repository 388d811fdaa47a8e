#pragma once

#include "experiment/job_ranges.hpp"
#include "messaging/samples.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace lamprey::coordinator {

using experiment::Digest;
using experiment::Id128;
using experiment::JobRanges;
using Clock = std::chrono::steady_clock;

/// A job that was alone in so many lost leases is next given to a worker that holds nothing else.
inline constexpr int losses_before_exclusive = 2;

struct LedgerOptions {
  Clock::duration lease_duration = std::chrono::seconds{5};          ///< since the last heartbeat that listed it
  Clock::duration lease_work = std::chrono::seconds{1};              ///< computation that one lease should amount to
  Clock::duration adoption_grace = std::chrono::milliseconds{1500};  ///< after a restart: first hear who holds what
  std::uint32_t default_attempts = 3;                                ///< where a sweep's policy names none
  std::uint64_t maximum_lease_jobs = 100'000;
  std::uint32_t maximum_window = 512;  ///< leases of one worker, whatever it asks for; as many as DDS keeps for it
  std::uint32_t maximum_refused_results = 10;  ///< of one worker's leases; then it gets no more
};

/// How a sweep's jobs are given out.
struct SweepPolicy {
  std::int32_t priority = 0;         ///< higher ones first; equal ones share
  std::uint64_t max_concurrent = 0;  ///< jobs leased at once; 0: any number
  double time_limit = 0;             ///< seconds; 0: any
  std::uint32_t attempts = 0;        ///< before quarantine; 0: LedgerOptions::default_attempts
  std::vector<std::string> needs{};  ///< labels that a worker must have
  bool needs_robot = false;          ///< only for workers that hold a robot's claim, which compute nothing else
};

/// A job that has cost its workers their lives too often; it gets a row of its own instead of another lease.
struct QuarantinedJob {
  Id128 sweep;
  std::uint64_t job = 0;
  std::uint32_t attempts = 0;
  std::uint64_t worker = 0;
  std::string reason;
};

/// A worker was lost with the job, or its result was refused.
struct FailedAttempt {
  Id128 sweep;
  std::uint64_t job = 0;
  std::uint64_t worker = 0;
  std::string end;       ///< lost, refused
  bool counted = false;  ///< towards quarantine
  std::string reason;
};

struct LostLease {
  std::uint64_t lease = 0;
  std::uint64_t worker = 0;
  Id128 sweep;
  std::uint64_t jobs = 0;
  std::string reason;
};

/// Which jobs are pending, which are leased to whom, which workers live: the coordinator's memory, rebuilt from SQLite
/// and from what workers report. It decides; it neither sends nor stores nor reads a clock. Not thread-safe.
class Ledger {
 public:
  Ledger(LedgerOptions options, Clock::time_point start, bool restarted, std::uint64_t first_lease);

  // ---- sweeps ----
  void add_sweep(const Id128& sweep, JobRanges open_jobs, SweepPolicy policy);
  /// The sweep's jobs are done and computed again to compare: each by another worker than its author.
  void add_audit(const Id128& audit, std::map<std::uint64_t, JobRanges> jobs_by_author);
  bool has_sweep(const Id128& sweep) const { return sweeps_.contains(sweep); }
  void add_jobs(const Id128& sweep, const JobRanges& jobs);
  void set_policy(const Id128& sweep, SweepPolicy policy);

  /// Nothing of it is granted until it is resumed. Returns the leases to revoke; their jobs are pending again.
  std::vector<messaging::Lease> pause(const Id128& sweep);
  void resume(const Id128& sweep);

  /// The job can go on where somebody has stopped: it is leased alone from now on.
  void note_checkpoint(const Id128& sweep, std::uint64_t job);
  bool has_checkpoint(const Id128& sweep, std::uint64_t job) const;

  /// Counted attempts of before a restart.
  void restore_attempts(const Id128& sweep, std::uint64_t job, const std::vector<std::uint64_t>& workers);

  /// Takes the sweep out: its jobs that have not ended, and the leases to revoke.
  struct Closed {
    JobRanges open_jobs;
    std::vector<messaging::Lease> revocations;
  };
  Closed close_sweep(const Id128& sweep);

  std::uint64_t pending(const Id128& sweep) const;
  std::uint64_t leased(const Id128& sweep) const;
  bool is_leased(const Id128& sweep, std::uint64_t job) const;
  /// Of an audit: pending jobs that none of the present workers but their author could take.
  std::uint64_t waiting_for_another_worker(const Id128& audit) const;

  // ---- workers ----
  /// What a heartbeat leads to, each to be sent to the worker: repeated grants, revocations, a refusal, a welcome.
  struct Heartbeat {
    bool joined = false;  ///< not known before
    bool left = false;    ///< it says goodbye; its leases are pending again
    std::vector<messaging::Lease> send;
    std::uint64_t adopted_jobs = 0;
    std::uint64_t repeated_leases = 0;
  };
  /// `status` is of this database's concern only in the leases that name it.
  Heartbeat heartbeat(const messaging::WorkerStatus& status, const Id128& database, Clock::time_point now);

  struct Expired {
    std::vector<LostLease> leases;
    std::vector<std::uint64_t> workers;  ///< not heard of for a lease's duration
    std::vector<QuarantinedJob> quarantined;
    std::vector<FailedAttempt> attempts;
  };
  Expired expire(Clock::time_point now);

  /// This program itself stood still for so long (a suspended machine): nobody was silent meanwhile.
  void forgive(Clock::duration pause);

  /// The worker finishes what it holds, gets nothing more and is told to leave, again and again until it does.
  /// The message to send now; nothing if no such worker is here.
  std::optional<messaging::Lease> drain(std::uint64_t worker);
  /// Workers that drain whenever they are heard of (they were told so before a restart).
  void remember_draining(const std::vector<std::uint64_t>& workers);

  bool knows(std::uint64_t worker) const { return workers_.contains(worker); }

  /// The build that a worker of now reports; nothing of others.
  std::optional<std::string> build_of(std::uint64_t worker) const;

  struct WorkerView {
    const messaging::WorkerStatus* status;
    std::size_t leases;
    Clock::time_point heard;
    bool refused = false;
  };
  std::vector<WorkerView> workers() const;
  std::size_t live_workers() const;
  std::size_t leases() const { return leases_.size(); }

  // ---- leases ----
  struct Grant {
    std::uint64_t worker = 0;
    messaging::Lease lease;  ///< origin left to the sender
  };
  /// New leases for every worker that has room, the same number for each as far as jobs last.
  std::vector<Grant> grant(Clock::time_point now);

  // ---- results ----
  /// Whether the job has neither a row nor been taken out: its result is wanted.
  bool is_open(const Id128& sweep, std::uint64_t job) const;
  /// Seconds that the job was pending before the lease that it is in, or 0.
  double queue_seconds(const Id128& sweep, std::uint64_t job, std::uint64_t lease);
  /// The job has a row now. `seconds` of computation teach the size of leases; negative: unknown.
  /// `lease`: under which the result came, if known.
  void ended(const Id128& sweep, std::uint64_t job, std::uint64_t lease, double seconds);
  /// A result of the worker that holds the job was refused: the job is pending again, or quarantined after as many
  /// different workers' results of it as there are attempts. A worker with too many of them gets no more leases. Of
  /// any other worker it changes nothing: nobody can quarantine a job that was not given to him.
  struct Refused {
    std::optional<FailedAttempt> attempt;
    std::optional<QuarantinedJob> quarantined;
    std::optional<messaging::Lease> farewell;  ///< to be sent to the worker, which is given up
  };
  Refused refused(const Id128& sweep, std::uint64_t job, std::uint64_t worker, const std::string& reason);
  std::uint32_t attempts(const Id128& sweep, std::uint64_t job) const;

 private:
  struct Lease {
    std::uint64_t worker = 0;
    Id128 sweep;
    JobRanges remaining;
    bool exclusive =
        false;  ///< a single suspect, given to a worker that holds nothing else: if it dies, it is the job's
    Clock::time_point granted;
    Clock::time_point renewed;
    Clock::time_point sent;
    int unlisted_heartbeats = 0;
    int repeats = 0;
  };
  struct Worker {
    messaging::WorkerStatus status;
    Clock::time_point heard;
    std::set<std::uint64_t> leases;
    std::map<Id128, Clock::time_point> not_before;  ///< sweeps whose leases it didn't take (another version, say)
    std::uint32_t refused_results = 0;
    std::uint32_t slots = 0;  ///< its part of slots_
    bool refused = false;
    bool exclusive = false;  ///< holds an exclusive lease
    bool draining = false;
  };
  using Workers = std::map<std::uint64_t, Worker>;
  struct Attempts {
    std::uint32_t count = 0;
    std::set<std::uint64_t> workers;  ///< that were lost, or refused, with it
  };
  struct Sweep {
    SweepPolicy policy;
    bool paused = false;
    Clock::time_point since;  ///< when its jobs became pending
    JobRanges pending;
    JobRanges resumable;  ///< pending too, but with a checkpoint: leased one by one, and first
    JobRanges leased;
    std::deque<JobRanges> suspects;  ///< parts of lost leases, each to be leased by itself; counted in no other set
    std::set<std::uint64_t> checkpointed;  ///< of all these, jobs that have a checkpoint
    std::map<std::uint64_t, int> losses;   ///< of jobs that were alone in a lost lease
    std::map<std::uint64_t, Attempts> attempts;
    std::map<std::uint64_t, JobRanges> authors;  ///< of an audit
    std::optional<double> seconds_per_job;
    std::size_t leases = 0;
  };
  using Sweeps = std::map<Id128, Sweep>;

  std::uint32_t maximum_attempts(const Sweep& sweep) const;
  static void put_back(Sweep& sweep, const JobRanges& jobs);
  static bool has_pending(const Sweep& sweep) { return !sweep.pending.empty() || !sweep.resumable.empty(); }
  static JobRanges allowed(const Sweep& sweep, std::uint64_t worker);
  static std::uint64_t room(const Sweep& sweep);
  std::vector<messaging::Lease> take_leases_back(const Id128& sweep, const std::string& reason);
  std::vector<Id128> grant_order() const;
  bool anything_to_grant(Clock::time_point now);
  messaging::Lease grant_message(std::uint64_t id, const Lease& lease) const;
  void repeat_unlisted(Worker& worker, const Id128& database, const std::set<std::uint64_t>& listed,
                       Heartbeat& reaction, Clock::time_point now);
  void adopt(Worker& worker, const messaging::HeldLease& held, Heartbeat& reaction, Clock::time_point now);
  void release(std::uint64_t id);
  void forget(std::map<std::uint64_t, Lease>::iterator lease);
  bool was_running(const Lease& lease) const;
  void lose(std::uint64_t id, const std::string& reason, Expired& expired);
  void lose_single(const Lease& lease, Sweep& sweep, JobRanges& rest, const std::string& reason, Expired& expired);
  std::optional<QuarantinedJob> count_attempt(Sweep& sweep, const Id128& id, std::uint64_t job, std::uint64_t worker,
                                              const std::string& reason);
  Workers::iterator remove(Workers::iterator worker);
  bool may_take(const Worker& worker) const;
  bool has_room(const Worker& worker) const;
  void note_capacity(std::uint64_t id, Worker& worker);
  static bool serves(const Worker& worker, const Id128& id, const Sweep& sweep, Clock::time_point now);
  bool grant_pending(std::uint64_t id, Worker& worker, std::vector<Grant>& grants, Clock::time_point now);
  bool grant_suspects(std::uint64_t id, Worker& worker, std::vector<Grant>& grants, Clock::time_point now);
  void give(std::uint64_t id, Worker& worker, const Id128& sweep, JobRanges jobs, bool exclusive,
            std::vector<Grant>& grants, Clock::time_point now);
  static JobRanges take_free(Sweep& sweep, const JobRanges& wanted);
  static bool take_suspect(Sweep& sweep, std::uint64_t job);
  std::map<std::uint64_t, Lease>::iterator lease_of(const Id128& sweep, std::uint64_t job, std::uint64_t hint);
  std::uint64_t lease_jobs(const Sweep& sweep) const;
  std::uint32_t window(const Worker& worker) const;

  LedgerOptions options_;
  Clock::time_point now_;  ///< of the latest call that told it
  Clock::time_point grants_from_;
  std::uint64_t next_lease_;
  Sweeps sweeps_;
  std::vector<Id128> order_;  ///< of submission
  Workers workers_;
  std::map<std::uint64_t, Lease> leases_;
  std::set<std::uint64_t> draining_;
  // So that a step in which nothing has happened costs the same with a thousand workers as with one:
  std::uint64_t slots_ = 0;             ///< leases that all workers together may hold
  std::set<std::uint64_t> with_room_;   ///< workers that may take one lease more
  bool may_grant_ = true;               ///< something has happened since the last grants
  std::set<Clock::time_point> pauses_;  ///< the ends of all not_before that are to come
  Clock::time_point expiry_due_;        ///< nobody can fall silent before
};

}  // namespace lamprey::coordinator
