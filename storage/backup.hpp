#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace lamprey::storage {

struct BackupOptions {
  bool replace = false;  ///< a Lamprey database at the target gives way
};

/// What has been copied.
struct BackupSummary {
  std::uint64_t sweeps = 0;
  std::uint64_t jobs = 0;  ///< that have ended
  std::uint64_t bytes = 0;
  int schema_version = 0;
};

/// Copies the database at `source` to `target` as it is at one moment, also while a coordinator writes it, which it
/// does not disturb: the coordinator's log only cannot be reset before the copy is complete. The copy is made beside
/// the target (`target`.part), checked and synchronized, and then takes the target's name: at no moment is a part of a
/// database there. `progress` is called now and then with the pages copied and those that there are; what it throws
/// ends the copying. Whatever fails, the target is as it was.
///
/// Throws StorageError: what opening the source for reading throws; network_file_system of the source; not_possible if
/// there is something at the target (with `replace`: something that is not a Lamprey database), if the target is the
/// source, or if a lost database's log is beside the target; in_use if a coordinator, another backup or, where it is
/// replaced, any other program uses the target; full, read_only, input_output of the copy.
BackupSummary back_up(const std::string& source, const std::string& target, const BackupOptions& options = {},
                      const std::function<void(std::uint64_t, std::uint64_t)>& progress = {});

}  // namespace lamprey::storage
