#include "storage/exclusive_lock.hpp"

#include "storage/connection.hpp"

#include <cerrno>
#include <fcntl.h>
#include <mutex>
#include <set>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace lamprey::storage {

namespace {

using FileKey = std::pair<dev_t, ino_t>;

/// Files locked by this process. Global because POSIX locks, which it protects, belong to the process too.
class LockedFiles {
 public:
  bool contains(const FileKey& file) {
    const std::lock_guard lock(mutex_);
    return files_.contains(file);
  }
  void add(const FileKey& file) {
    const std::lock_guard lock(mutex_);
    files_.insert(file);
  }
  void remove(const FileKey& file) {
    const std::lock_guard lock(mutex_);
    files_.erase(file);
  }

 private:
  std::mutex mutex_;
  std::set<FileKey> files_;
};

LockedFiles& locked_files() {
  static LockedFiles files;
  return files;
}

std::optional<FileKey> key_of(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return FileKey{status.st_dev, status.st_ino};
}

FileKey key_of(int descriptor) {
  struct stat status {};
  fstat(descriptor, &status);
  return {status.st_dev, status.st_ino};
}

}  // namespace

std::optional<ExclusiveLock> ExclusiveLock::try_lock(const std::string& path, bool create) {
  if (const auto file = key_of(path); file && locked_files().contains(*file)) return std::nullopt;
  const int descriptor = open(path.c_str(), O_RDWR | O_CLOEXEC | (create ? O_CREAT : 0), 0666);
  if (descriptor < 0) throw_system_error(path, "open");
  if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    const int reason = errno;
    close(descriptor);
    errno = reason;
    if (reason == EWOULDBLOCK) return std::nullopt;
    throw_system_error(path, "flock");
  }
  locked_files().add(key_of(descriptor));
  return ExclusiveLock(descriptor);
}

ExclusiveLock::~ExclusiveLock() {
  if (descriptor_ < 0) return;
  locked_files().remove(key_of(descriptor_));
  close(descriptor_);
}

ExclusiveLock::ExclusiveLock(ExclusiveLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

ExclusiveLock& ExclusiveLock::operator=(ExclusiveLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

bool ExclusiveLock::is_of(const std::string& path) const {
  return key_of(path) == key_of(descriptor_);
}

void ExclusiveLock::synchronize(const std::string& path) const {
  if (fsync(descriptor_) != 0) throw_system_error(path, "fsync");
}

}  // namespace lamprey::storage
