#pragma once

#include "client/json.hpp"
#include "client/tool.hpp"
#include "messaging/in_memory/bus.hpp"

#include <atomic>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace lamprey::tests {

/// What one call of the tool wrote and how it ended.
struct ToolRun {
  int exit_code = 0;
  std::string out;
  std::string err;

  /// `out` as one JSON document; a discarded value if it is none.
  client::Json json() const { return client::Json::parse(out, nullptr, false); }
};

/// A place for files, and a bus that the tool joins instead of DDS.
class Site {
 public:
  Site();
  ~Site();

  messaging::in_memory::Bus bus;
  std::atomic<bool> interrupted = false;

  ToolRun run(const std::vector<std::string>& arguments, std::size_t columns = 100);

  /// Writes a file and gives its path.
  std::string file(const std::string& name, const std::string& text) const;
  std::string path(const std::string& name) const { return (directory_ / name).string(); }

  /// A database with the sweep; its first `done` jobs computed, the next one failed.
  std::string database(const std::string& yaml, std::uint64_t done) const;

 private:
  std::filesystem::path directory_;
};

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

/// Eight quick jobs.
extern const char* const small_sweep;

}  // namespace lamprey::tests
