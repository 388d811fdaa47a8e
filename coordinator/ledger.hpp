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

struct LedgerOptions {
  Clock::duration lease_duration = std::chrono::seconds{5};          ///< since the last heartbeat that listed it
  Clock::duration lease_work = std::chrono::seconds{1};              ///< computation that one lease should amount to
  Clock::duration adoption_grace = std::chrono::milliseconds{1500};  ///< after a restart: first hear who holds what
  std::uint32_t maximum_attempts = 3;
  std::uint64_t maximum_lease_jobs = 100'000;
  std::uint32_t maximum_window = 512;  ///< leases of one worker, whatever it asks for; as many as DDS keeps for it
  std::uint32_t maximum_refused_results = 10;  ///< of one worker's leases; then it gets no more
};

/// A job that has cost its workers their lives too often; it gets a row of its own instead of another lease.
struct QuarantinedJob {
  Id128 sweep;
  std::uint64_t job = 0;
  std::uint32_t attempts = 0;
  std::uint64_t worker = 0;
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
  void add_sweep(const Id128& sweep, std::uint64_t jobs, const JobRanges& ended);

  /// Takes the sweep out: its jobs that have not ended, and the leases to revoke.
  struct Closed {
    JobRanges open_jobs;
    std::vector<messaging::Lease> revocations;
  };
  Closed close_sweep(const Id128& sweep);

  std::uint64_t pending(const Id128& sweep) const;
  std::uint64_t leased(const Id128& sweep) const;

  // ---- workers ----
  /// What a heartbeat leads to, each to be sent to the worker: repeated grants, revocations, a refusal, a welcome.
  struct Heartbeat {
    bool joined = false;  ///< not known before
    bool left = false;    ///< it says goodbye; its leases are pending again
    std::vector<messaging::Lease> send;
    std::uint64_t adopted_jobs = 0;
  };
  /// `status` is of this database's concern only in the leases that name it.
  Heartbeat heartbeat(const messaging::WorkerStatus& status, const Id128& database, Clock::time_point now);

  struct Expired {
    std::vector<LostLease> leases;
    std::vector<std::uint64_t> workers;  ///< not heard of for a lease's duration
    std::vector<QuarantinedJob> quarantined;
  };
  Expired expire(Clock::time_point now);

  /// This program itself stood still for so long (a suspended machine): nobody was silent meanwhile.
  void forgive(Clock::duration pause);

  bool knows(std::uint64_t worker) const { return workers_.contains(worker); }

  /// The build that a worker of now reports; nothing of others.
  std::optional<std::string> build_of(std::uint64_t worker) const;

  struct WorkerView {
    const messaging::WorkerStatus* status;
    std::size_t leases;
  };
  std::vector<WorkerView> workers() const;
  std::size_t live_workers() const;

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
  /// The job has a row now. `seconds` of computation teach the size of leases; negative: unknown.
  /// `lease`: under which the result came, if known.
  void ended(const Id128& sweep, std::uint64_t job, std::uint64_t lease, double seconds);
  /// A result of the worker that holds the job was refused: the job is pending again, or quarantined after as many
  /// different workers' results of it as there are attempts. A worker with too many of them gets no more leases. Of
  /// any other worker it changes nothing: nobody can quarantine a job that was not given to him.
  struct Refused {
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
    std::uint64_t sequence = 0;
    bool exclusive =
        false;  ///< a single suspect, given to a worker that holds nothing else: if it dies, it is the job's
    Clock::time_point renewed;
    Clock::time_point sent;
    int unlisted_heartbeats = 0;
    int repeats = 0;
  };
  struct Worker {
    messaging::WorkerStatus status;
    Clock::time_point heard;
    std::uint64_t next_sequence = 1;
    std::set<std::uint64_t> leases;
    std::map<Id128, Clock::time_point> not_before;  ///< sweeps whose leases it didn't take (another version, say)
    std::uint32_t refused_results = 0;
    bool refused = false;
    bool exclusive = false;  ///< holds an exclusive lease
  };
  struct Attempts {
    std::uint32_t count = 0;
    std::set<std::uint64_t> workers;  ///< that were lost, or refused, with it
  };
  struct Sweep {
    JobRanges pending;
    JobRanges leased;
    std::deque<JobRanges> suspects;  ///< parts of lost leases, each to be leased by itself; counted in no other set
    std::map<std::uint64_t, Attempts> attempts;
    std::optional<double> seconds_per_job;
  };

  messaging::Lease grant_message(std::uint64_t id, const Lease& lease) const;
  void repeat_unlisted(Worker& worker, const std::set<std::uint64_t>& listed, Heartbeat& reaction,
                       Clock::time_point now);
  void adopt(Worker& worker, const messaging::HeldLease& held, Heartbeat& reaction, Clock::time_point now);
  void release(std::uint64_t id);
  void forget(std::map<std::uint64_t, Lease>::iterator lease);
  bool was_running(const Lease& lease) const;
  void lose(std::uint64_t id, const std::string& reason, Expired& expired);
  std::optional<QuarantinedJob> count_attempt(Sweep& sweep, const Id128& id, std::uint64_t job, std::uint64_t worker,
                                              const std::string& reason);
  bool may_take(const Worker& worker) const;
  static bool serves(const Worker& worker, const Id128& sweep, Clock::time_point now);
  bool grant_pending(std::uint64_t id, Worker& worker, std::vector<Grant>& grants, Clock::time_point now);
  bool grant_suspects(std::uint64_t id, Worker& worker, std::vector<Grant>& grants, Clock::time_point now);
  void give(std::uint64_t id, Worker& worker, const Id128& sweep, JobRanges jobs, bool exclusive,
            std::vector<Grant>& grants, Clock::time_point now);
  static JobRanges take_free(Sweep& sweep, const JobRanges& wanted);
  static bool take_suspect(Sweep& sweep, std::uint64_t job);
  std::map<std::uint64_t, Lease>::iterator lease_of(const Id128& sweep, std::uint64_t job, std::uint64_t hint);
  std::uint64_t lease_jobs(const Sweep& sweep) const;
  std::uint32_t window(const Worker& worker) const;
  std::uint64_t slots() const;

  LedgerOptions options_;
  Clock::time_point grants_from_;
  std::uint64_t next_lease_;
  std::map<Id128, Sweep> sweeps_;
  std::vector<Id128> order_;  ///< of submission
  std::map<std::uint64_t, Worker> workers_;
  std::map<std::uint64_t, Lease> leases_;
};

}  // namespace lamprey::coordinator
