#pragma once

#include "coordinator/coordinator.hpp"
#include "messaging/in_memory/bus.hpp"
#include "worker/worker.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace lamprey::tests {

using coordinator::Clock;
using messaging::in_memory::Bus;
using messaging::in_memory::Envelope;
using messaging::in_memory::Fate;

/// Runs the real engine, a few jobs per step, on the caller's thread: work is in flight between steps, and every run of
/// a test is the same.
class SteppedExecutor final : public worker::JobExecutor {
 public:
  std::size_t jobs_per_step = 4;
  std::function<void(const worker::Task&)> before_job;  ///< may kill the worker by throwing WorkerDied
  std::function<bool(const worker::Task&)> fails;       ///< instead of being computed
  std::function<bool(const worker::Task&)> gives_back;  ///< likewise
  std::multiset<std::uint64_t> computed;

  struct WorkerDied {};

  std::size_t wanted() const override { return jobs_per_step - std::min(jobs_per_step, queue_.size()); }
  void submit(std::vector<worker::Task> tasks) override;
  std::vector<worker::FinishedTask> take_finished() override;
  std::vector<messaging::Checkpoint> take_checkpoints() override { return {}; }
  std::vector<messaging::RunningJob> running() const override;
  void drop(const experiment::Id128& database, std::uint64_t lease) override;
  /// Nothing runs between two steps.
  void interrupt(const experiment::Id128& database, std::uint64_t lease) override { drop(database, lease); }
  void stop() override { queue_.clear(); }
  bool idle() const override { return queue_.empty(); }
  std::uint32_t threads() const override { return 1; }

 private:
  std::vector<worker::Task> queue_;
  std::unique_ptr<experiment::BatchEngine> engine_ = experiment::make_scalar_engine();
};

/// A coordinator with a database of its own and any number of workers on an in-memory bus with faults, under a clock
/// that only the test moves.
class Site {
 public:
  Site();
  ~Site();

  Bus bus;
  Clock::time_point now{std::chrono::hours{1}};
  coordinator::CoordinatorOptions coordinator_options;
  worker::OutboxOptions outbox_options;
  std::size_t jobs_per_step = 4;
  std::string vfs;  ///< SQLite's, of the database; empty: the default one

  struct WorkerProcess {
    std::string name;
    std::unique_ptr<messaging::Participant> participant;
    std::unique_ptr<SteppedExecutor> executor;  ///< none if the test has brought its own
    std::unique_ptr<worker::JobExecutor> own_executor;
    std::unique_ptr<worker::Worker> worker;
    std::uint64_t incarnation = 0;
  };

  void start_coordinator();
  void kill_coordinator();
  bool coordinator_runs() const { return coordinator_ != nullptr; }
  WorkerProcess& start_worker();
  /// With an executor of the test's own.
  WorkerProcess& start_worker(std::unique_ptr<worker::JobExecutor> executor);
  void kill_worker(std::size_t index);
  WorkerProcess& worker(std::size_t index) { return *workers_.at(index); }
  std::size_t workers() const { return workers_.size(); }

  /// Sends the request as a client would and steps until the reply has come.
  idl::Reply ask(const idl::Request& request);
  /// Submits the YAML and remembers what its outcomes must be.
  void submit(const std::string& yaml);

  void advance(std::chrono::milliseconds time);
  /// Steps until the condition holds; false if it does not within `limit` of simulated time.
  bool run_until(const std::function<bool()>& condition, std::chrono::seconds limit = std::chrono::seconds{120});
  bool run_to_end() {
    return run_until([this] { return ended(); });
  }
  bool ended();

  std::uint64_t rows(const std::string& where = "1");
  std::uint64_t number(const std::string& sql);
  /// Changes the database behind everybody's back.
  void write(const std::string& sql);
  /// Every job of every submitted sweep has exactly one row, done, with the digest of an undisturbed computation.
  void expect_complete();
  /// How often jobs were computed over all workers that ever lived.
  std::size_t computed() const;

  experiment::Id128 database_id() const;
  std::filesystem::path database() const { return directory_ / "results.db"; }

 private:
  WorkerProcess& start(std::unique_ptr<WorkerProcess> process, worker::JobExecutor& executor);

  std::filesystem::path directory_;
  std::shared_ptr<messaging::Signal> signal_ = std::make_shared<messaging::Signal>();
  std::unique_ptr<messaging::Participant> coordinator_participant_;
  std::unique_ptr<coordinator::Coordinator> coordinator_;
  std::vector<std::unique_ptr<WorkerProcess>> workers_;
  std::vector<experiment::SweepFile> sweeps_;
  std::uint64_t next_incarnation_ = 0xa0;
  std::uint64_t next_client_ = 0xc0;
  std::size_t computed_by_the_dead_ = 0;
};

/// A sweep of `jobs` quick jobs (a multiple of 4).
std::string small_sweep(const std::string& name, std::uint64_t jobs = 96);

}  // namespace lamprey::tests
