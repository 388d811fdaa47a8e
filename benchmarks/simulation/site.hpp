#pragma once

#include "benchmarks/simulation/executor.hpp"
#include "benchmarks/simulation/lease_latency.hpp"
#include "coordinator/coordinator.hpp"
#include "messaging/in_memory/bus.hpp"
#include "worker/worker.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace lamprey::benchmarks {

/// What the coordinator's steps have cost since the last time that it was asked.
struct Cost {
  std::uint64_t steps = 0;
  double cpu = 0;      ///< seconds of its thread
  double wall = 0;     ///< seconds, with those that it waited for the disk
  double longest = 0;  ///< seconds of one step
  double elapsed = 0;  ///< simulated seconds from first to last
};

/// The real coordinator on a real database, and real workers on the in-memory bus, in one thread. Time is simulated:
/// workers compute side by side, however many there are, and take no time for their protocol; a step of the
/// coordinator takes as long as it has really taken, and meanwhile nobody else gets on. So the coordinator is exactly
/// as much of a bottleneck as it would be with a processor of its own.
class Site {
 public:
  /// `database` is made anew. Each job takes `job_time` of simulated time.
  Site(std::size_t workers, Clock::duration job_time, const std::string& database);

  /// Lets time pass.
  Cost pass(Clock::duration time);

  /// Sends the sweep file to the coordinator, and waits until every worker has what it has room for; the longest step
  /// is the one that has granted it. Throws if the coordinator refuses the sweep.
  Cost submit(const std::string& sweep_file);

  /// Until so many jobs of the sweep are done. Throws if that takes an hour of simulated time.
  Cost work(std::uint64_t jobs);

  const LeaseLatency& latency() const { return latency_; }
  /// Of the time since the sweep was submitted, what its workers have computed.
  double share_computing() const;

 private:
  struct SimulatedWorker {
    std::unique_ptr<messaging::Participant> participant;
    std::unique_ptr<SimulatedExecutor> executor;
    std::unique_ptr<worker::Worker> worker;
    Clock::time_point due;
    bool has_mail = true;
  };

  SimulatedWorker make_worker(std::uint64_t incarnation, Clock::duration job_time);
  messaging::in_memory::Fate note(const messaging::in_memory::Envelope& envelope);
  void tick(Cost& cost);
  void step_coordinator(Cost& cost);

  Clock::time_point now_{std::chrono::hours{1}};
  Clock::time_point step_began_{};  ///< the real one's
  bool coordinator_steps_ = false;
  Clock::time_point submitted_{};
  Clock::time_point coordinator_due_{};
  LeaseLatency latency_;
  messaging::in_memory::Bus bus_;
  std::shared_ptr<messaging::Signal> signal_ = std::make_shared<messaging::Signal>();
  std::unique_ptr<experiment::BatchEngine> engine_ = experiment::make_scalar_engine();
  std::unique_ptr<messaging::Participant> observer_;
  std::unique_ptr<messaging::Reader<messaging::SweepProgress>> progress_;
  std::unique_ptr<messaging::Participant> participant_;
  std::unique_ptr<coordinator::Coordinator> coordinator_;
  std::vector<SimulatedWorker> workers_;  ///< by their incarnation − 1
};

}  // namespace lamprey::benchmarks
