#include "storage/results_store.hpp"

#include "storage/database_file.hpp"
#include "storage/job_row.hpp"
#include "storage/migration.hpp"
#include "storage/schema.hpp"
#include "storage/store_implementation.hpp"
#include "storage/sweep_row.hpp"

#include <filesystem>

namespace lamprey::storage {

namespace {

using Kind = StorageError::Kind;

/// From this many pages of 4 KiB on the write-ahead log is copied into the database after a commit.
constexpr int checkpoint_pages = 4096;

/// If readers have kept it from being reset up to this many, the writer waits for them, briefly.
constexpr int patience_pages = 4 * checkpoint_pages;
constexpr int patience_milliseconds = 100;

/// What a reset log keeps on disk.
constexpr int kept_log_bytes = 64 << 20;

/// Checks without changing anything, then opens for writing.
Connection open_for_writing(const std::string& path, const std::string& vfs) {
  {
    const Connection reading = open_for_reading(path, vfs);
    const auto stored = read_database_row(reading).science_version;
    if (stored != experiment::science_version) {
      throw StorageError(Kind::other_science, path + ": holds outcomes of science version " + std::to_string(stored) +
                                                  ", this program computes those of " +
                                                  std::to_string(experiment::science_version) +
                                                  ": use another database, or the Lamprey that wrote this one");
    }
  }
  Connection connection(path, SQLITE_OPEN_READWRITE, vfs);
  connection.execute("PRAGMA foreign_keys = ON");
  connection.execute("PRAGMA synchronous = FULL");
  connection.execute("PRAGMA cache_size = -65536");
  connection.execute("PRAGMA journal_size_limit = " + std::to_string(kept_log_bytes));
  Statement mode(connection, "PRAGMA journal_mode = WAL");
  if (!mode.step() || mode.text(0) != "wal") {
    throw StorageError(Kind::input_output, path + ": SQLite cannot use its write-ahead log here");
  }
  return connection;
}

/// Tables, views and parameters of this program, and the next epoch, in one transaction.
Opening begin_epoch(const Connection& connection) {
  std::optional<TablesMayBeRebuilt> rebuilding;
  if (stored_schema_version(connection) < schema_version) rebuilding.emplace(connection);
  Transaction transaction(connection, Transaction::Mode::write);
  const std::string migration = bring_up_to_date(connection);
  Statement(connection, "UPDATE database SET epoch = epoch + 1, opened = ?").with(unix_milliseconds()).run();
  const std::uint64_t epoch = read_database_row(connection).epoch;
  BatchWriter writer(connection, epoch);
  writer.write(Event{"database_opened", {}, {}, 0, "epoch " + std::to_string(epoch)});
  if (!migration.empty()) writer.write(Event{"schema_migrated", {}, {}, 0, migration});
  transaction.commit();
  return {epoch, migration};
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void insert_sweep(const Connection& connection, const NewSweep& sweep) {
  const std::string id = experiment::to_hex(sweep.id);
  const auto checksum = sweep_checksum(sweep, experiment::science_version);
  Statement(connection,
            "INSERT INTO sweep (id, name, state, specification, source, seed, replicates, jobs, science_version, "
            "checksum, created, fresh, execution) VALUES (?, ?, 'running', ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .with(std::string_view(id), std::string_view(sweep.name), bytes_of(sweep.specification),
            std::string_view(sweep.source), sweep.seed, sweep.replicates, sweep.jobs, experiment::science_version,
            std::span<const std::uint8_t>(checksum), unix_milliseconds(), sweep.fresh, bytes_of(sweep.execution))
      .run();
}

}  // namespace

ResultsStore::Implementation::Implementation(const std::string& database_path, const StoreOptions& options)
    : path(database_path),
      lock(lock_or_create(path, options.vfs)),
      connection(open_for_writing(path, options.vfs)),
      opening(begin_epoch(connection)),
      database_id(read_database_row(connection).id),
      writer(connection, opening.epoch),
      find_job(connection, "SELECT state, digest, worker FROM job WHERE sweep = ? AND job = ?"),
      read_job(connection, "SELECT " + job_columns() + " FROM job WHERE sweep = ? AND job = ?"),
      next_wait_pages(patience_pages) {
  // Instead of SQLite's own checkpoint after a commit: ours also waits for readers when it must.
  const auto committed = [](void* self, sqlite3*, const char*, int pages) {
    static_cast<Implementation*>(self)->log_pages = pages;
    return SQLITE_OK;
  };
  sqlite3_wal_hook(connection.handle(), committed, this);
}

Sweep ResultsStore::Implementation::changeable_sweep(std::int64_t sweep) const {
  const auto stored = find_sweep_by(connection, "sweep", sweep);
  if (!stored)
    throw StorageError(Kind::not_possible, path + ": there is no sweep with the key " + std::to_string(sweep));
  if (stored->state == SweepState::deleting) {
    throw StorageError(Kind::not_possible, path + ": the sweep '" + stored->what.name + "' is being deleted");
  }
  return *stored;
}

/// What has been committed is durable in the log, so a checkpoint that fails is no failure of the commit: the log stays
/// and grows, which log_size() tells, and the next commit tries again.
void ResultsStore::Implementation::bound_log() {
  if (log_pages < checkpoint_pages) {
    held_by_reader = false;
    next_wait_pages = patience_pages;
    return;
  }
  int in_log = 0;
  int copied = 0;
  sqlite3_wal_checkpoint_v2(connection.handle(), nullptr, SQLITE_CHECKPOINT_PASSIVE, &in_log, &copied);
  held_by_reader = copied < in_log;
  if (log_pages < next_wait_pages) return;
  // Readers that overlap can hold the log for ever although each is quick. New ones don't once all is copied, so it is
  // enough to wait for those of now. If one stays, the next wait is for a log that has grown noticeably again.
  sqlite3_busy_timeout(connection.handle(), patience_milliseconds);
  const int code = sqlite3_wal_checkpoint_v2(connection.handle(), nullptr, SQLITE_CHECKPOINT_RESTART, &in_log, &copied);
  sqlite3_busy_timeout(connection.handle(), busy_milliseconds);
  held_by_reader = code == SQLITE_BUSY;
  next_wait_pages = log_pages + checkpoint_pages;
}

ResultsStore::ResultsStore(const std::string& path, const StoreOptions& options)
    : implementation_(std::make_unique<Implementation>(path, options)) {}
ResultsStore::~ResultsStore() = default;
ResultsStore::ResultsStore(ResultsStore&&) noexcept = default;
ResultsStore& ResultsStore::operator=(ResultsStore&&) noexcept = default;

const std::string& ResultsStore::path() const {
  return implementation_->path;
}
experiment::Id128 ResultsStore::database_id() const {
  return implementation_->database_id;
}
std::uint64_t ResultsStore::epoch() const {
  return implementation_->opening.epoch;
}
const std::string& ResultsStore::migration() const {
  return implementation_->opening.migration;
}
std::vector<Sweep> ResultsStore::sweeps() const {
  return read_sweeps(implementation_->connection);
}

ResultsStore::Added ResultsStore::add_sweep(const NewSweep& sweep) {
  const auto& connection = implementation_->connection;
  const std::string id = experiment::to_hex(sweep.id);
  if (auto existing = find_sweep_by(connection, "id", std::string_view(id))) return {std::move(*existing), true};
  if (const auto other = find_sweep_by(connection, "name", std::string_view(sweep.name))) {
    throw StorageError(Kind::name_taken, path() + ": another sweep has the name '" + sweep.name + "' (id " +
                                             experiment::to_hex(other->what.id) + "); give this one another name");
  }
  return implementation_->write([&]() -> Added {
    insert_sweep(connection, sweep);
    auto added = find_sweep_by(connection, "id", std::string_view(id));
    implementation_->writer.write(
        Event{"sweep_submitted", added->row, {}, 0, sweep.name + ": " + std::to_string(sweep.jobs) + " jobs"});
    return {std::move(*added), false};
  });
}

std::optional<std::string> ResultsStore::build_of(std::uint64_t worker) const {
  return find_build(implementation_->connection, worker);
}

void ResultsStore::commit(const Batch& batch) {
  if (batch.empty()) return;
  implementation_->write([&] {
    implementation_->writer.write(batch);
    return true;
  });
}

ResultsStore::LogSize ResultsStore::log_size() const {
  const char* database = sqlite3_db_filename(implementation_->connection.handle(), "main");
  std::error_code no_file;
  const auto bytes = std::filesystem::file_size(sqlite3_filename_wal(database), no_file);
  return {no_file ? 0 : bytes, implementation_->held_by_reader};
}

}  // namespace lamprey::storage
