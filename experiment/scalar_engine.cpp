#include "experiment/batch_engine.hpp"
#include "experiment/checkpoint.hpp"
#include "experiment/job_run.hpp"
#include "experiment/parameters.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <string>
#include <utility>

namespace lamprey::experiment {

namespace {

using Clock = std::chrono::steady_clock;
using Result = std::variant<Outcome, Failure, Interrupted>;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// How many cycles to go before looking up: as many as take about two milliseconds, which costs nothing and stops at
/// once. An outcome does not depend on it.
class Portion {
 public:
  std::uint32_t cycles() const { return cycles_; }
  void took(double seconds) {
    if (seconds < 0.001) cycles_ = std::min(2 * cycles_, most_cycles_per_step);
    if (seconds > 0.004) cycles_ = std::max(cycles_ / 2, 1U);
  }

 private:
  std::uint32_t cycles_ = 16;
};

/// One job, from where it begins to its end.
class Computation {
 public:
  Computation(const Assignment& assignment, std::size_t number, BatchWatcher& watcher, const std::stop_token& stop)
      : assignment_(assignment), number_(number), watcher_(watcher), stop_(stop) {}

  BatchResult result() {
    BatchResult result{.identity = identity(assignment_.job), .result = outcome_or_failure()};
    result.seconds = seconds();
    return result;
  }

 private:
  Result outcome_or_failure() {
    try {
      return run();
    } catch (const std::exception& error) {
      return Failure{error.what()};
    }
  }

  Result run() {
    if (stop_.stop_requested()) return Interrupted{assignment_.checkpoint};
    JobRun run = begun();
    Portion portion;
    double last_look = seconds();
    while (!run.finished()) {
      if (exceeded()) return Failure{"exceeded its time limit of " + to_text(Value(assignment_.time_limit)) + " s"};
      if (stop_.stop_requested() || obey(run) == BatchWatcher::Order::interrupt) {
        return Interrupted{write_checkpoint(run, assignment_.job, seconds())};
      }
      go_on(run, portion.cycles());
      const double now = seconds();
      portion.took(now - std::exchange(last_look, now));
    }
    return std::move(run).take();
  }

  JobRun begun() {
    if (!assignment_.checkpoint.empty()) {
      try {
        Resumed resumed = resume(assignment_.job, assignment_.checkpoint);
        seconds_before_ = resumed.seconds;
        return std::move(resumed.run);
      } catch (const CheckpointError& error) {
        watcher_.begins_anew(number_, error.what());
      }
    }
    return JobRun(assignment_.job);
  }

  BatchWatcher::Order obey(const JobRun& run) {
    const Progress progress{.cycle = run.outcome().cycles, .seconds = seconds()};
    const BatchWatcher::Order order = watcher_.look(number_, progress);
    if (order == BatchWatcher::Order::save) {
      watcher_.saved(number_, progress, write_checkpoint(run, assignment_.job, progress.seconds));
    }
    return order;
  }

  static void go_on(JobRun& run, std::uint32_t cycles) {
    const std::uint32_t end = run.outcome().cycles + cycles;
    while (!run.finished() && run.outcome().cycles < end) run.advance(end - run.outcome().cycles);
  }

  bool exceeded() const { return assignment_.time_limit > 0 && seconds() >= assignment_.time_limit; }
  double seconds() const { return seconds_before_ + seconds_since(start_); }

  const Assignment& assignment_;
  std::size_t number_;
  BatchWatcher& watcher_;
  const std::stop_token& stop_;
  Clock::time_point start_ = Clock::now();
  double seconds_before_ = 0;  ///< of the runs that the checkpoint joins
};

class ScalarEngine final : public BatchEngine {
 public:
  std::size_t preferred_batch() const override { return 1; }

  std::vector<BatchResult> run(std::span<const Assignment> batch, BatchWatcher& watcher,
                               std::stop_token stop) override {
    std::vector<BatchResult> results;
    results.reserve(batch.size());
    for (const Assignment& assignment : batch) {
      results.push_back(Computation(assignment, results.size(), watcher, stop).result());
    }
    return results;
  }
};

}  // namespace

std::unique_ptr<BatchEngine> make_scalar_engine() {
  return std::make_unique<ScalarEngine>();
}

}  // namespace lamprey::experiment
