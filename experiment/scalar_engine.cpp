#include "experiment/batch_engine.hpp"
#include "experiment/job_run.hpp"

#include <chrono>
#include <exception>

namespace lamprey::experiment {

namespace {

std::variant<Outcome, Failure, Interrupted> run_or_fail(const Job& job, const std::stop_token& stop) {
  try {
    auto result = run_job(job, stop);
    if (auto* outcome = std::get_if<Outcome>(&result)) return std::move(*outcome);
    return Interrupted{};
  } catch (const std::exception& error) {
    return Failure{error.what()};
  }
}

class ScalarEngine final : public BatchEngine {
 public:
  std::size_t preferred_batch() const override { return 1; }

  std::vector<BatchResult> run(std::span<const Job> jobs, std::stop_token stop) override {
    using Clock = std::chrono::steady_clock;
    std::vector<BatchResult> results;
    results.reserve(jobs.size());
    for (const Job& job : jobs) {
      const auto start = Clock::now();
      BatchResult result{.identity = identity(job), .result = run_or_fail(job, stop)};
      result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
      results.push_back(std::move(result));
    }
    return results;
  }
};

}  // namespace

std::unique_ptr<BatchEngine> make_scalar_engine() {
  return std::make_unique<ScalarEngine>();
}

}  // namespace lamprey::experiment
