#pragma once

#include "tests/client/site.hpp"

#include <atomic>
#include <string>
#include <thread>

namespace lamprey::tests {

/// A coordinator (with a worker, if wanted) on the site's bus, on a thread of its own.
class RunningCoordinator {
 public:
  RunningCoordinator(Site& site, const std::string& database, bool with_worker);
  ~RunningCoordinator();

 private:
  void serve(std::string database, bool with_worker);

  Site& site_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace lamprey::tests
