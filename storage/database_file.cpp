#include "storage/database_file.hpp"

#include "storage/schema.hpp"
#include "storage/statement.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <string_view>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>
#include <vector>

namespace lamprey::storage {

namespace {

using Kind = StorageError::Kind;

/// The header of an SQLite file: https://www.sqlite.org/fileformat2.html, section 1.3.
struct Header {
  static constexpr std::size_t size = 100;
  std::array<unsigned char, size> bytes{};

  bool is_sqlite() const {
    constexpr std::string_view magic("SQLite format 3\0", 16);
    return std::equal(magic.begin(), magic.end(), bytes.begin());
  }
  std::uint32_t application_id() const {
    constexpr std::size_t offset = 68;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | bytes[offset + i];
    return value;
  }
};

struct FreeFilename {
  void operator()(const char* name) const noexcept { sqlite3_free_filename(name); }
};

/// Reads the header through SQLite's own file layer, which postpones the closing of a descriptor while a connection of
/// this process has locks on the file (see ExclusiveLock).
Header read_header(const std::string& path, const std::string& vfs_name) {
  sqlite3_initialize();
  sqlite3_vfs* vfs = sqlite3_vfs_find(vfs_name.empty() ? nullptr : vfs_name.c_str());
  if (vfs == nullptr) throw StorageError(Kind::input_output, path + ": no such SQLite VFS: " + vfs_name);
  const auto absolute = std::filesystem::absolute(path).string();
  const std::unique_ptr<const char, FreeFilename> name(sqlite3_create_filename(absolute.c_str(), "", "", 0, nullptr));
  // SQLite's file objects are as large as their VFS says and begin with their methods.
  std::vector<std::max_align_t> memory(static_cast<std::size_t>(vfs->szOsFile) / sizeof(std::max_align_t) + 1);
  auto* file = reinterpret_cast<sqlite3_file*>(memory.data());
  errno = 0;
  const int opened = vfs->xOpen(vfs, name.get(), file, SQLITE_OPEN_READONLY | SQLITE_OPEN_MAIN_DB, nullptr);
  if (opened != SQLITE_OK) {
    if (file->pMethods != nullptr) file->pMethods->xClose(file);
    throw StorageError(error_kind(opened, errno),
                       path + ": open: " + sqlite3_errstr(opened) + ": " + std::strerror(errno));
  }
  Header header;
  const int code = file->pMethods->xRead(file, header.bytes.data(), static_cast<int>(Header::size), 0);
  file->pMethods->xClose(file);
  // What a short file lacks has been filled with zeros.
  if (code != SQLITE_OK && code != SQLITE_IOERR_SHORT_READ) {
    throw StorageError(error_kind(code), path + ": read: " + sqlite3_errstr(code));
  }
  return header;
}

[[noreturn]] void refuse_second(const std::string& path) {
  throw StorageError(Kind::in_use, path + ": another coordinator is using this database");
}

/// Fills the locked file at `path` with an empty database.
void write_new_database(const std::string& path, const std::string& vfs) {
  if (truncate(path.c_str(), 0) != 0) throw_system_error(path, "truncate");
  for (const char* suffix : {"-wal", "-shm", "-journal"}) unlink((path + suffix).c_str());
  const Connection connection(path, SQLITE_OPEN_READWRITE, vfs);
  connection.execute("PRAGMA synchronous = FULL");
  Transaction transaction(connection, Transaction::Mode::write);
  create_tables(connection);
  refresh_views(connection);
  transaction.commit();
  connection.execute("PRAGMA journal_mode = WAL");
}

/// Makes the database under another name first, so that `path` is never a part of one. Returns nothing if somebody else
/// has been faster: look again.
std::optional<ExclusiveLock> create(const std::string& path, const std::string& vfs) {
  refuse_remains(path);
  const std::string unfinished = path + ".new";
  auto lock = ExclusiveLock::try_lock(unfinished, true);
  if (!lock) refuse_second(path);
  if (!lock->is_of(unfinished) || inspect(path, vfs) != FileContent::nothing) {
    if (lock->is_of(unfinished)) unlink(unfinished.c_str());
    return std::nullopt;
  }
  write_new_database(unfinished, vfs);
  lock->synchronize(unfinished);
  if (rename(unfinished.c_str(), path.c_str()) != 0) throw_system_error(path, "rename");
  synchronize_directory(directory_of(path));
  return lock;
}

}  // namespace

std::string directory_of(const std::string& path) {
  const auto parent = std::filesystem::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

void refuse_remains(const std::string& path) {
  for (const char* suffix : {"-wal", "-journal"}) {
    struct stat status {};
    if (stat((path + suffix).c_str(), &status) == 0 && status.st_size > 0) {
      throw StorageError(Kind::input_output,
                         path + ": does not exist, but " + path + suffix +
                             " does, which belongs to a database that was moved or removed: move it back or away");
    }
  }
}

void synchronize_directory(const std::string& directory) {
  const int descriptor = open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) throw_system_error(directory, "open");
  const int result = fsync(descriptor);
  const int reason = errno;
  close(descriptor);
  errno = reason;
  if (result != 0) throw_system_error(directory, "fsync");
}

bool is_network_file_system(std::uint32_t type) {
  // linux/magic.h and statfs(2). FUSE isn't among them: most of its file systems are local.
  constexpr std::array<std::uint32_t, 12> network = {
      0x6969,      // NFS
      0x517b,      // SMB
      0xff534d42,  // CIFS
      0xfe534d42,  // SMB2
      0x5346414f,  // AFS
      0x6b414653,  // kAFS
      0x73757245,  // Coda
      0x564c,      // NCP
      0x01021997,  // 9P
      0x00c36400,  // Ceph
      0x0bd00bd0,  // Lustre
      0x47504653,  // GPFS
  };
  return std::ranges::find(network, type) != network.end();
}

void refuse_network_file_system(const std::string& path) {
  struct statfs status {};
  if (statfs(path.c_str(), &status) != 0 && statfs(directory_of(path).c_str(), &status) != 0)
    throw_system_error(path, "statfs");
  if (is_network_file_system(static_cast<std::uint32_t>(status.f_type))) {
    throw StorageError(Kind::network_file_system,
                       path + ": on a network file system, where SQLite cannot lock reliably; use a local disk");
  }
}

FileContent inspect(const std::string& path, const std::string& vfs) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    if (errno != ENOENT && errno != ENOTDIR) throw_system_error(path, "stat");
    const std::string directory = directory_of(path);
    if (stat(directory.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) {
      throw StorageError(Kind::missing, path + ": the directory " + directory + " does not exist");
    }
    return FileContent::nothing;
  }
  if (S_ISDIR(status.st_mode)) throw StorageError(Kind::not_a_database, path + ": is a directory");
  if (!S_ISREG(status.st_mode)) throw StorageError(Kind::not_a_database, path + ": is not a regular file");
  if (status.st_size == 0) return FileContent::nothing;
  const Header header = read_header(path, vfs);
  if (!header.is_sqlite()) throw StorageError(Kind::not_a_database, path + ": is not an SQLite database");
  if (header.application_id() != application_id) {
    throw StorageError(Kind::not_a_database, path + ": is an SQLite database of another application");
  }
  return FileContent::lamprey;
}

Connection open_for_reading(const std::string& path, const std::string& vfs) {
  Connection connection(path, SQLITE_OPEN_READONLY, vfs);
  connection.execute("PRAGMA query_only = ON");
  const int stored = stored_schema_version(connection);
  if (stored > schema_version) {
    throw StorageError(Kind::newer_schema, path + ": was written by a later Lamprey (schema version " +
                                               std::to_string(stored) + ", this program knows up to " +
                                               std::to_string(schema_version) + ")");
  }
  Statement table(connection, "SELECT count(*) FROM sqlite_master WHERE name = 'schema_version'");
  if (stored < 1 || !table.step() || table.integer(0) != 1) {
    throw StorageError(Kind::not_a_database, path + ": lacks the tables of a Lamprey database");
  }
  return connection;
}

std::string older_schema_text(int version) {
  return "has schema version " + std::to_string(version) + ", this program's is " + std::to_string(schema_version) +
         ": start lamprey-coordinator --database on it once, which brings it up to date";
}

Connection open_existing(const std::string& path) {
  if (inspect(path, "") == FileContent::nothing) {
    const bool exists = std::filesystem::exists(path);
    throw StorageError(exists ? Kind::not_a_database : Kind::missing,
                       path + (exists ? ": is empty" : ": does not exist"));
  }
  return open_for_reading(path, "");
}

ExclusiveLock lock_or_create(const std::string& path, const std::string& vfs) {
  // A database may appear, or be replaced, between looking and locking; then look again.
  for (int attempt = 0; attempt < 10; ++attempt) {
    const auto content = inspect(path, vfs);
    refuse_network_file_system(path);
    if (content == FileContent::nothing) {
      if (auto lock = create(path, vfs)) return std::move(*lock);
      continue;
    }
    auto lock = ExclusiveLock::try_lock(path, false);
    if (!lock) refuse_second(path);
    if (lock->is_of(path)) return std::move(*lock);
  }
  throw StorageError(Kind::in_use, path + ": other programs keep replacing this file");
}

}  // namespace lamprey::storage
