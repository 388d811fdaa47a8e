#pragma once

#include <optional>
#include <string>

namespace lamprey::storage {

/// flock(2) on a file: whoever holds it is the one coordinator of that database. The kernel releases it with the
/// process, however that ends.
///
/// SQLite's own locks on the same file are POSIX locks, which belong to the process and are dropped when *any*
/// descriptor of the file is closed. So the lock is taken before SQLite opens the file and must outlive the last
/// connection; and a second attempt within the process is refused before a descriptor is opened at all.
/// Thread-safe in the sense that several threads may try.
class ExclusiveLock {
 public:
  /// Opens the file (making it with `create`, mode 0666 less the umask) and locks it, or returns nothing if another
  /// process, or this one, holds it. Throws StorageError if the file cannot be opened.
  static std::optional<ExclusiveLock> try_lock(const std::string& path, bool create);

  ~ExclusiveLock();
  ExclusiveLock(ExclusiveLock&& other) noexcept;
  ExclusiveLock& operator=(ExclusiveLock&& other) noexcept;

  /// Whether `path` still names the locked file (and not one that has taken its place).
  bool is_of(const std::string& path) const;

  /// fsync of the file.
  void synchronize(const std::string& path) const;

 private:
  explicit ExclusiveLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace lamprey::storage
