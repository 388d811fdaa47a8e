#include "tests/client/running_coordinator.hpp"

#include "coordinator/coordinator.hpp"
#include "storage/results_store.hpp"
#include "worker/worker.hpp"

#include <chrono>
#include <memory>
#include <utility>

namespace lamprey::tests {

RunningCoordinator::RunningCoordinator(Site& site, const std::string& database, bool with_worker)
    : site_(site), thread_([this, database, with_worker] { serve(database, with_worker); }) {}

RunningCoordinator::~RunningCoordinator() {
  stop_ = true;
  thread_.join();
}

void RunningCoordinator::serve(std::string database, bool with_worker) {
  const auto now = [] { return std::chrono::steady_clock::now(); };
  const auto signal = std::make_shared<messaging::Signal>();
  const auto participant = site_.bus.join("coordinator");
  coordinator::Coordinator coordinator(*participant, storage::ResultsStore(database), signal, {}, now());
  const auto worker_participant = site_.bus.join("worker");
  const auto executor = worker::make_thread_pool(1, signal);
  worker::WorkerOptions options;
  options.incarnation = 0xabc;
  options.host = "test-host";
  options.build = "test";
  worker::Worker worker(*worker_participant, *executor, signal, options, now());
  while (!stop_) {
    coordinator.step(now());
    if (with_worker) worker.step(now());
    signal->wait_for(std::chrono::milliseconds{5});
  }
  coordinator.finish(now());
}

}  // namespace lamprey::tests
