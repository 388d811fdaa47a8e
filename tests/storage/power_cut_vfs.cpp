#include "tests/storage/power_cut_vfs.hpp"

#include "tests/storage/support.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace lamprey::storage::testing {

namespace {

constexpr std::size_t sector_bytes = 512;

void apply(std::string& content, std::size_t offset, std::string_view bytes) {
  if (content.size() < offset + bytes.size()) content.resize(offset + bytes.size(), '\0');
  content.replace(offset, bytes.size(), bytes);
}

}  // namespace

/// The C functions that SQLite calls. A file object is a File, followed by the real VFS's own object.
struct PowerCutMethods {
  struct File {
    sqlite3_file base;
    PowerCutVfs* vfs;
    std::string* path;  ///< key of its disk; nullptr for a temporary file, which never survives anyway
    sqlite3_file* real;
  };

  static File& of(sqlite3_file* file) { return *reinterpret_cast<File*>(file); }
  static sqlite3_file* real(sqlite3_file* file) { return of(file).real; }
  static PowerCutVfs& of(sqlite3_vfs* vfs) { return *static_cast<PowerCutVfs*>(vfs->pAppData); }
  static PowerCutVfs::Disk& disk(File& file) { return file.vfs->disks_.at(*file.path); }

  static int open(sqlite3_vfs* vfs, sqlite3_filename name, sqlite3_file* opened, int flags, int* out_flags) {
    auto& self = of(vfs);
    auto& file = of(opened);
    file.base.pMethods = nullptr;
    file.vfs = &self;
    file.path = nullptr;
    file.real = reinterpret_cast<sqlite3_file*>(&file + 1);
    if (self.cut_) return SQLITE_CANTOPEN;
    const bool existed = name != nullptr && std::filesystem::exists(name);
    const int code = self.real_->xOpen(self.real_, name, file.real, flags, out_flags);
    if (code != SQLITE_OK) return code;
    if (name != nullptr) {
      const auto [entry, added] = self.disks_.try_emplace(name);
      auto& disk = entry->second;
      if (added && existed) disk.durable = bytes_of(name);
      disk.deleted = false;
      ++disk.open_handles;
      file.path = new std::string(name);
    }
    file.base.pMethods = &methods;
    return SQLITE_OK;
  }

  static int close(sqlite3_file* closed) {
    auto& file = of(closed);
    if (file.path != nullptr) {
      auto& disk = PowerCutMethods::disk(file);
      // The file may be renamed from now on, and has nothing to lose.
      if (--disk.open_handles == 0 && disk.pending.empty() && !disk.replaced && disk.durable) {
        file.vfs->disks_.erase(*file.path);
      }
      delete file.path;
    }
    return file.real->pMethods->xClose(file.real);
  }

  static int write(sqlite3_file* written, const void* data, int size, sqlite3_int64 offset) {
    auto& file = of(written);
    if (file.path == nullptr) return file.real->pMethods->xWrite(file.real, data, size, offset);
    const bool had_power = !file.vfs->cut_;
    const auto refused = file.vfs->refuse(SQLITE_IOERR_WRITE);
    // Of the write in which the power goes a part may come through.
    if (!refused || (had_power && file.vfs->cut_)) {
      disk(file).pending.push_back({static_cast<std::size_t>(offset),
                                    std::string(static_cast<const char*>(data), static_cast<std::size_t>(size))});
    }
    return refused ? *refused : file.real->pMethods->xWrite(file.real, data, size, offset);
  }

  static int truncate(sqlite3_file* truncated, sqlite3_int64 size) {
    auto& file = of(truncated);
    if (file.path == nullptr) return file.real->pMethods->xTruncate(file.real, size);
    if (const auto refused = file.vfs->refuse(SQLITE_IOERR_TRUNCATE)) return *refused;
    disk(file).pending.push_back({static_cast<std::size_t>(size), std::nullopt});
    return file.real->pMethods->xTruncate(file.real, size);
  }

  static int sync(sqlite3_file* synchronized, int) {
    auto& file = of(synchronized);
    if (file.path == nullptr) return SQLITE_OK;
    if (const auto refused = file.vfs->refuse(SQLITE_IOERR_FSYNC)) return *refused;
    auto& synced = disk(file);
    if (synced.replaced || !synced.durable) synced.durable.emplace();
    for (const auto& change : synced.pending) {
      if (change.bytes) {
        apply(*synced.durable, change.offset, *change.bytes);
      } else {
        synced.durable->resize(change.offset, '\0');
      }
    }
    synced.replaced = false;
    synced.pending.clear();
    return SQLITE_OK;
  }

  static int remove(sqlite3_vfs* vfs, const char* name, int synchronize_directory) {
    auto& self = of(vfs);
    if (const auto refused = self.refuse(SQLITE_IOERR_DELETE)) return *refused;
    const auto entry = self.disks_.find(name);
    if (synchronize_directory != 0) {
      if (entry != self.disks_.end()) self.disks_.erase(entry);
    } else {
      auto& disk = entry != self.disks_.end() ? entry->second : self.disks_[name];
      if (entry == self.disks_.end() && std::filesystem::exists(name)) disk.durable = bytes_of(name);
      disk.replaced = disk.deleted = true;
      disk.pending.clear();
    }
    return self.real_->xDelete(self.real_, name, 0);
  }

  static int read(sqlite3_file* file, void* data, int size, sqlite3_int64 offset) {
    if (of(file).vfs->cut_) return SQLITE_IOERR_READ;
    return real(file)->pMethods->xRead(real(file), data, size, offset);
  }

  static int file_size(sqlite3_file* file, sqlite3_int64* size) {
    return real(file)->pMethods->xFileSize(real(file), size);
  }
  static int lock(sqlite3_file* file, int level) { return real(file)->pMethods->xLock(real(file), level); }
  static int unlock(sqlite3_file* file, int level) { return real(file)->pMethods->xUnlock(real(file), level); }
  static int check_reserved_lock(sqlite3_file* file, int* result) {
    return real(file)->pMethods->xCheckReservedLock(real(file), result);
  }
  static int file_control(sqlite3_file* file, int operation, void* argument) {
    return real(file)->pMethods->xFileControl(real(file), operation, argument);
  }
  static int sector_size(sqlite3_file* file) { return real(file)->pMethods->xSectorSize(real(file)); }
  static int device_characteristics(sqlite3_file* file) {
    return real(file)->pMethods->xDeviceCharacteristics(real(file));
  }
  static int shm_map(sqlite3_file* file, int page, int size, int extend, void volatile** memory) {
    return real(file)->pMethods->xShmMap(real(file), page, size, extend, memory);
  }
  static int shm_lock(sqlite3_file* file, int offset, int count, int flags) {
    return real(file)->pMethods->xShmLock(real(file), offset, count, flags);
  }
  static void shm_barrier(sqlite3_file* file) { real(file)->pMethods->xShmBarrier(real(file)); }
  static int shm_unmap(sqlite3_file* file, int remove_file) {
    return real(file)->pMethods->xShmUnmap(real(file), remove_file);
  }

  static int access(sqlite3_vfs* vfs, const char* name, int flags, int* result) {
    return of(vfs).real_->xAccess(of(vfs).real_, name, flags, result);
  }
  static int full_pathname(sqlite3_vfs* vfs, const char* name, int size, char* full) {
    return of(vfs).real_->xFullPathname(of(vfs).real_, name, size, full);
  }
  static int randomness(sqlite3_vfs* vfs, int size, char* bytes) {
    return of(vfs).real_->xRandomness(of(vfs).real_, size, bytes);
  }
  static int sleep(sqlite3_vfs* vfs, int microseconds) { return of(vfs).real_->xSleep(of(vfs).real_, microseconds); }
  static int current_time(sqlite3_vfs* vfs, double* days) { return of(vfs).real_->xCurrentTime(of(vfs).real_, days); }
  static int last_error(sqlite3_vfs* vfs, int size, char* text) {
    auto& self = of(vfs);
    if (self.fail_at_ && self.system_error_ != 0) return self.system_error_;
    return self.real_->xGetLastError(self.real_, size, text);
  }

  static constexpr sqlite3_io_methods methods = {
      .iVersion = 2,  // 3 would map the file and write past us
      .xClose = close,
      .xRead = read,
      .xWrite = write,
      .xTruncate = truncate,
      .xSync = sync,
      .xFileSize = file_size,
      .xLock = lock,
      .xUnlock = unlock,
      .xCheckReservedLock = check_reserved_lock,
      .xFileControl = file_control,
      .xSectorSize = sector_size,
      .xDeviceCharacteristics = device_characteristics,
      .xShmMap = shm_map,
      .xShmLock = shm_lock,
      .xShmBarrier = shm_barrier,
      .xShmUnmap = shm_unmap,
      .xFetch = nullptr,
      .xUnfetch = nullptr,
  };
};

PowerCutVfs::PowerCutVfs() : vfs_(std::make_unique<sqlite3_vfs>()) {
  sqlite3_initialize();
  real_ = sqlite3_vfs_find(nullptr);
  name_ = "power-cut-" + std::to_string(reinterpret_cast<std::uintptr_t>(this));
  vfs_->iVersion = 1;
  vfs_->szOsFile = static_cast<int>(sizeof(PowerCutMethods::File)) + real_->szOsFile;
  vfs_->mxPathname = real_->mxPathname;
  vfs_->zName = name_.c_str();
  vfs_->pAppData = this;
  vfs_->xOpen = PowerCutMethods::open;
  vfs_->xDelete = PowerCutMethods::remove;
  vfs_->xAccess = PowerCutMethods::access;
  vfs_->xFullPathname = PowerCutMethods::full_pathname;
  vfs_->xRandomness = PowerCutMethods::randomness;
  vfs_->xSleep = PowerCutMethods::sleep;
  vfs_->xCurrentTime = PowerCutMethods::current_time;
  vfs_->xGetLastError = PowerCutMethods::last_error;
  sqlite3_vfs_register(vfs_.get(), 0);
}

PowerCutVfs::~PowerCutVfs() {
  sqlite3_vfs_unregister(vfs_.get());
}

void PowerCutVfs::fail_from(std::uint64_t operation, int code, int system_error) {
  fail_at_ = operations_ + operation;
  fail_code_ = code;
  system_error_ = system_error;
}

std::optional<int> PowerCutVfs::refuse(int code) {
  if (cut_) return code;
  ++operations_;
  if (cut_at_ && operations_ >= *cut_at_) {
    cut_ = true;
    return code;
  }
  if (fail_at_ && operations_ >= *fail_at_) return fail_code_;
  return std::nullopt;
}

std::optional<std::string> PowerCutVfs::after_cut(const Disk& disk, Survival survival, std::mt19937_64& random) const {
  const auto chance = [&] { return survival == Survival::by_chance && random() % 2 == 0; };
  std::optional<std::string> content = disk.durable;
  if (disk.replaced) {
    if (!chance()) return content;  // the directory still names the old file
    if (disk.deleted) return std::nullopt;
    content.emplace();
  } else if (!content) {
    if (!chance()) return std::nullopt;  // the directory doesn't name the new file yet
    content.emplace();
  }
  for (const auto& change : disk.pending) {
    if (!change.bytes) {
      if (chance()) content->resize(change.offset, '\0');
      continue;
    }
    const bool whole = chance();
    const bool none = chance();
    for (std::size_t done = 0; done < change.bytes->size() && !none; done += sector_bytes) {
      if (whole || chance()) {
        apply(*content, change.offset + done, std::string_view(*change.bytes).substr(done, sector_bytes));
      }
    }
  }
  return content;
}

void PowerCutVfs::restart(Survival survival, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (const auto& [path, disk] : disks_) {
    if (const auto content = after_cut(disk, survival, random)) {
      write_bytes(path, *content);
    } else {
      std::filesystem::remove(path);
    }
    std::filesystem::remove(path + "-shm");
  }
  start_anew();
}

void PowerCutVfs::start_anew() {
  disks_.clear();
  cut_at_.reset();
  fail_at_.reset();
  cut_ = false;
}

}  // namespace lamprey::storage::testing
