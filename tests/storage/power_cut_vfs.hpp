#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <sqlite3.h>
#include <string>
#include <vector>

namespace lamprey::storage::testing {

/// An SQLite VFS over the default one that can lose power. Reads, locks and shared memory go to the real files, which
/// play the part of the system's page cache; what would be on the disk is kept apart and grows only with xSync. After a
/// cut every operation fails until restart() has put the disk's state into the files, as a machine would find them.
///
/// Not synchronized writes survive not at all, or each of their 512-byte sectors by chance, in any order. A file whose
/// creation or deletion was not synchronized is there or not, by chance. SQLite's shared-memory file is always gone.
/// Not thread-safe. Files with an open connection must not be renamed.
class PowerCutVfs {
 public:
  /// Registers the VFS with SQLite, under a name of its own.
  PowerCutVfs();
  ~PowerCutVfs();
  PowerCutVfs(const PowerCutVfs&) = delete;
  PowerCutVfs& operator=(const PowerCutVfs&) = delete;

  const std::string& name() const { return name_; }

  /// The power goes in the n-th operation from now (from 1) that writes, truncates, deletes or synchronizes.
  void cut_at(std::uint64_t operation) { cut_at_ = operations_ + operation; }
  void cut_now() { cut_ = true; }
  bool is_cut() const { return cut_; }

  /// From the n-th operation on they fail with this result code, and the system's reason where it has one, until
  /// repair(); nothing is lost.
  void fail_from(std::uint64_t operation, int code, int system_error = 0);
  void repair() { fail_at_.reset(); }

  /// Counted since the VFS was made.
  std::uint64_t operations() const { return operations_; }

  enum class Survival { none, by_chance };
  /// To be called when all connections are closed.
  void restart(Survival survival, std::uint64_t seed);

  /// Takes the files as they are now for what the disk has, and forgets planned cuts and failures. To be called when
  /// all connections are closed.
  void start_anew();

 private:
  friend struct PowerCutMethods;

  struct Write {
    std::size_t offset = 0;
    std::optional<std::string> bytes;  ///< nothing: the file was truncated to `offset`
  };
  /// What the disk has of a file, and what it does not have yet.
  struct Disk {
    std::optional<std::string> durable;  ///< nothing: no such file
    bool replaced = false;  ///< the file of `durable` was deleted, without its directory being synchronized
    bool deleted = false;   ///< … and there is none in its place
    std::vector<Write> pending;
    int open_handles = 0;
  };

  /// Counts an operation; its result code if it must not be carried out.
  std::optional<int> refuse(int code);
  std::optional<std::string> after_cut(const Disk& disk, Survival survival, std::mt19937_64& random) const;

  std::string name_;
  sqlite3_vfs* real_;
  std::unique_ptr<sqlite3_vfs> vfs_;
  std::map<std::string, Disk> disks_;
  std::uint64_t operations_ = 0;
  std::optional<std::uint64_t> cut_at_;
  bool cut_ = false;
  std::optional<std::uint64_t> fail_at_;
  int fail_code_ = SQLITE_OK;
  int system_error_ = 0;
};

}  // namespace lamprey::storage::testing
