#pragma once

#include "storage/connection.hpp"
#include "storage/exclusive_lock.hpp"
#include "storage/results_store.hpp"

#include <cstdint>
#include <string>

namespace lamprey::storage {

enum class FileContent : std::uint8_t {
  nothing,  ///< no such file, or one of 0 bytes
  lamprey,  ///< a Lamprey database by its header
};

/// What is at `path`, found without changing it. Throws StorageError if that is something else: a directory, a file of
/// another kind, another application's database; or if its directory doesn't exist.
FileContent inspect(const std::string& path, const std::string& vfs);

/// Throws StorageError if a log without its database is at `path`: it may hold results that were acknowledged, which
/// are not ours to delete, and SQLite would take it for a new database's.
void refuse_remains(const std::string& path);

std::string directory_of(const std::string& path);

/// Makes what has been created, renamed or removed in the directory durable. Throws StorageError.
void synchronize_directory(const std::string& directory);

/// Opens read-only the database that inspect() has found and checks what its header doesn't tell: throws newer_schema,
/// not_a_database (tables missing), corrupt.
Connection open_for_reading(const std::string& path, const std::string& vfs);

/// "has schema version 1 …" and what to do about it, for messages.
std::string older_schema_text(int version);

/// The same for whoever only reads: refuses also what doesn't exist (missing) or is empty (not_a_database).
Connection open_existing(const std::string& path);

/// The lock on the database, which is made if there is none. When it returns the file is a whole database, whatever
/// happens to the power. Throws StorageError: in_use, and what inspect() throws.
ExclusiveLock lock_or_create(const std::string& path, const std::string& vfs);

/// Throws StorageError if `path`, or the directory that it will be in, is on a network file system: locks and shared
/// memory, which SQLite's write-ahead log needs, don't work there between machines.
void refuse_network_file_system(const std::string& path);

/// Whether statfs(2) calls a file system of this type one that other machines may write to.
bool is_network_file_system(std::uint32_t type);

}  // namespace lamprey::storage
