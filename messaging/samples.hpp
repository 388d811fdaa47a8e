#pragma once

#include "experiment/identifiers.hpp"
#include "experiment/outcome.hpp"
#include "messaging/robot_samples.hpp"
#include "messaging/traffic.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// What travels between the programs: neutral value types, one per topic. idl/lamprey.idl has the same fields for the
/// wire; messaging/<vendor>/ converts. Everything in them that came from the network is unchecked input.
namespace lamprey::messaging {

using experiment::Digest;
using experiment::Id128;

/// Half-open on purpose of counting: jobs first, first + 1, … first + count − 1.
struct JobRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
  bool operator==(const JobRange&) const = default;
};

/// Carried by every sample: whose world it belongs to.
struct Origin {
  Id128 database;            ///< zero where the sender does not know it yet
  std::uint64_t epoch = 0;   ///< of the coordinator that the sender last obeyed (or is)
  std::uint64_t worker = 0;  ///< incarnation of the worker that sends, or that is meant; 0 if none
  std::uint32_t science_version = 0;
  bool operator==(const Origin&) const = default;
};

enum class WorkerState : std::uint8_t { ready = 0, draining = 1, leaving = 2 };

/// A lease as its holder sees it: the jobs of it that have no terminal acknowledgement yet.
struct HeldLease {
  Id128 database;
  std::uint64_t epoch = 0;
  std::uint64_t lease = 0;
  Id128 sweep;
  std::vector<JobRange> remaining;
  bool operator==(const HeldLease&) const = default;
};

struct RunningJob {
  Id128 sweep;
  std::uint64_t job = 0;
  std::uint32_t cycle = 0;  ///< the number of cycles done
  double seconds = 0;       ///< of computation so far, over all attempts that a checkpoint joins
  bool operator==(const RunningJob&) const = default;
};

/// What a program has counted since it started: refused, dropped, repeated.
struct Counter {
  std::string name;  ///< [a-z_]+
  std::uint64_t value = 0;
  bool operator==(const Counter&) const = default;
};

/// The label of a worker that holds a claim just now. A robot's worker always has "bridge=" and the robot's name, too.
inline constexpr std::string_view robot_label = "bridge";

/// Worker → coordinator and observers: heartbeat and everything the coordinator decides by. Key: origin.worker.
struct WorkerStatus {
  Origin origin;
  std::uint64_t heartbeat = 0;  ///< counts up from 1
  WorkerState state = WorkerState::ready;
  std::uint32_t threads = 0;
  std::uint32_t window = 0;               ///< how many leases it is willing to hold
  std::uint64_t last_lease_sequence = 0;  ///< highest Lease::sequence received in origin.epoch
  std::uint64_t jobs_done = 0;            ///< in this incarnation
  std::uint64_t results_held = 0;         ///< computed, not yet acknowledged
  std::vector<HeldLease> leases;
  std::vector<RunningJob> running;
  std::string host;
  std::uint32_t process = 0;
  std::string build;            ///< version and commit
  std::string flags;            ///< compiler and flags of the build
  std::string processor;        ///< the host's, as it names itself
  std::string instruction_set;  ///< that jobs are computed with
  std::string dds;              ///< vendor
  std::vector<std::string> labels;
  std::vector<Counter> counters;
  bool operator==(const WorkerStatus&) const = default;
};

/// Coordinator → workers: what a sweep is. Key: sweep.
struct SweepSpecification {
  Origin origin;
  Id128 sweep;
  std::string name;
  bool open = true;                         ///< false: ended; a worker may forget it
  std::vector<std::uint8_t> specification;  ///< idl::SweepSpecification; empty once closed
  bool operator==(const SweepSpecification&) const = default;
};

enum class LeaseKind : std::uint8_t {
  welcome = 0,  ///< the coordinator knows the worker; nothing to do yet
  grant = 1,
  revoke = 2,  ///< drop what has not started, `interrupt`: also what runs; results that exist are still to be sent
  refuse = 3,  ///< the worker gets no leases, for `reason`
  drain = 4,   ///< finish what is held, then leave
};

/// Coordinator → one worker (partition of its own).
struct Lease {
  Origin origin;
  LeaseKind kind = LeaseKind::grant;
  std::uint64_t sequence = 0;  ///< of a grant: its lease's number, which grows with each; else 0
  std::uint64_t lease = 0;     ///< unique within the database
  Id128 sweep;
  std::vector<JobRange> ranges;
  std::uint32_t duration_milliseconds =
      0;                  ///< on the coordinator's steady clock, renewed by each heartbeat that lists it
  double time_limit = 0;  ///< seconds of computation that each job may take; 0: any
  bool interrupt = false;
  std::vector<std::uint8_t> checkpoint;  ///< of a grant of one job: where it goes on (experiment/checkpoint.hpp)
  std::string reason;
  bool operator==(const Lease&) const = default;
};

enum class ResultKind : std::uint8_t { done = 0, failed = 1 };

/// One job's end, or a part of it: a long trace and long measures are cut over several fragments (fragmentation.hpp),
/// each with the same head and its own slice of them; it is committed whole or not at all.
struct JobResult {
  std::uint64_t job = 0;
  ResultKind kind = ResultKind::done;
  std::uint64_t lease = 0;     ///< under which it was computed
  std::uint32_t fragment = 0;  ///< 0-based
  std::uint32_t fragments = 1;
  Digest identity{};
  Digest digest{};                      ///< of the whole outcome; zero for a failed job
  experiment::Outcome outcome;          ///< trace, measures: this fragment's slice
  double seconds = 0;                   ///< of computation
  double waited = 0;                    ///< seconds that it waited at the worker before
  std::string reason;                   ///< of a failure
  std::vector<std::uint8_t> recording;  ///< idl::RobotRecording of a job on a robot: this fragment's slice
  bool operator==(const JobResult&) const = default;
};

/// Worker → coordinator, at most about 64 KB.
struct ResultBatch {
  Origin origin;
  std::uint64_t sequence = 0;  ///< counts up from 1 per incarnation
  Id128 sweep;
  std::vector<JobResult> results;
  bool operator==(const ResultBatch&) const = default;
};

enum class Verdict : std::uint8_t { committed = 0, duplicate = 1, divergent = 2, refused = 3 };

/// Terminal: whatever the verdict, the worker forgets the result.
struct Acknowledgement {
  Id128 sweep;
  std::uint64_t job = 0;
  Digest digest{};  ///< of the result that is answered
  Verdict verdict = Verdict::committed;
  std::string reason;
  bool operator==(const Acknowledgement&) const = default;
};

/// Coordinator → one worker (partition of its own), after the commit.
struct ResultAcknowledgement {
  Origin origin;
  std::vector<Acknowledgement> results;
  bool operator==(const ResultAcknowledgement&) const = default;
};

/// Worker → coordinator, while a long job runs and when one is interrupted: only the newest of a job matters, and none
/// is answered.
struct Checkpoint {
  Origin origin;
  Id128 sweep;
  std::uint64_t job = 0;
  std::uint64_t lease = 0;
  std::uint32_t cycle = 0;  ///< the number of cycles done
  double seconds = 0;       ///< of computation so far
  Digest identity{};
  std::vector<std::uint8_t> state;  ///< experiment/checkpoint.hpp
  bool operator==(const Checkpoint&) const = default;
};

/// Client → coordinator.
struct Request {
  Origin origin;
  std::uint64_t client = 0;           ///< names the client's partition
  std::uint64_t correlation = 0;      ///< the same for a repeated request
  std::vector<std::uint8_t> payload;  ///< idl::Request
  bool operator==(const Request&) const = default;
};

/// Coordinator → one client (partition of its own).
struct Reply {
  Origin origin;
  std::uint64_t client = 0;
  std::uint64_t correlation = 0;
  std::vector<std::uint8_t> payload;  ///< idl::Reply
  bool operator==(const Reply&) const = default;
};

/// Coordinator → anyone. Key: sweep.
struct SweepProgress {
  Origin origin;
  Id128 sweep;
  std::string name;
  std::string state;  ///< running, paused, cancelling, cancelled, finished, deleting
  std::uint64_t jobs = 0;
  std::uint64_t pending = 0;
  std::uint64_t leased = 0;
  std::uint64_t done = 0;
  std::uint64_t failed = 0;
  std::uint64_t quarantined = 0;
  std::uint64_t cancelled = 0;
  std::uint64_t divergences = 0;
  double jobs_per_second = 0;
  double seconds_left = -1;   ///< negative: not known yet
  std::uint32_t workers = 0;  ///< alive
  bool operator==(const SweepProgress&) const = default;
};

}  // namespace lamprey::messaging
