#include "experiment/batch_engine.hpp"

#include <utility>

namespace lamprey::experiment {

namespace {

class Unwatched final : public BatchWatcher {
 public:
  Order look(std::size_t /*job*/, const Progress& /*progress*/) override { return Order::go_on; }
  void saved(std::size_t /*job*/, const Progress& /*progress*/, std::vector<std::uint8_t> /*checkpoint*/) override {}
  void begins_anew(std::size_t /*job*/, const std::string& /*reason*/) override {}
};

}  // namespace

std::vector<BatchResult> BatchEngine::run(std::span<const Job> jobs, std::stop_token stop) {
  std::vector<Assignment> batch;
  batch.reserve(jobs.size());
  for (const Job& job : jobs) batch.push_back({.job = job});
  Unwatched unwatched;
  return run(batch, unwatched, std::move(stop));
}

}  // namespace lamprey::experiment
