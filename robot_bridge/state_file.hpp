#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace lamprey::robot_bridge {

/// What a robot must not forget when its bridge ends, however it ends.
struct StoredState {
  std::uint64_t newest_token = 0;
  bool stopped = false;     ///< the emergency stop, latched
  std::string stop_reason;  ///< who stopped it and why
  bool operator==(const StoredState&) const = default;
};

/// A robot's state in a small JSON file, `NAME.json` in a folder that is made where it is missing. While it is open no
/// other bridge can open it: two must not move one robot. Not thread-safe.
class StateFile {
 public:
  /// Reads it, or begins with a default state where there is none. Throws std::runtime_error naming file and reason: it
  /// is in use, can't be read or written, or holds what no bridge has written (it is never overwritten then).
  StateFile(const std::filesystem::path& folder, const std::string& robot);
  ~StateFile();
  StateFile(const StateFile&) = delete;
  StateFile& operator=(const StateFile&) = delete;

  const StoredState& state() const { return state_; }

  /// Returns when it is on the disk; throws std::runtime_error if it can't be, and then the old state stands.
  void store(const StoredState& state);

  /// The emergency stop is in force from now on, whether or not it can be stored; then it throws as store().
  void latch(const std::string& reason);

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;
  StoredState state_;
};

/// $XDG_STATE_HOME/lamprey/robots, or $HOME/.local/state/lamprey/robots, or for want of both /var/lib/lamprey/robots.
std::filesystem::path default_state_folder();

}  // namespace lamprey::robot_bridge
