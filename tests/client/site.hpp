#pragma once

#include "client/json.hpp"
#include "client/tool.hpp"
#include "messaging/in_memory/bus.hpp"

#include <atomic>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
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
  std::vector<std::string> joined;          ///< the vendors, in order
  std::string unjoinable;                   ///< a vendor
  messaging::discovery::DomainView domain;  ///< what discovery tells

  ToolRun run(const std::vector<std::string>& arguments, std::size_t columns = 100);

  /// Writes a file and gives its path.
  std::string file(const std::string& name, const std::string& text) const;
  std::string path(const std::string& name) const { return (directory_ / name).string(); }

  /// A database with the sweep; its first `done` jobs computed, the next one failed.
  std::string database(const std::string& yaml, std::uint64_t done) const;

 private:
  std::filesystem::path directory_;
};

/// Eight quick jobs.
extern const char* const small_sweep;

}  // namespace lamprey::tests
