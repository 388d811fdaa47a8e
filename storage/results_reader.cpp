#include "storage/results_reader.hpp"

#include "storage/database_file.hpp"
#include "storage/job_row.hpp"
#include "storage/json_rows.hpp"
#include "storage/sweep_row.hpp"

namespace lamprey::storage {

namespace {

using Kind = StorageError::Kind;

/// A query comes from a user and must not reach other files or SQLite's internals.
Connection open_for_queries(const std::string& path) {
  Connection connection = open_existing(path);
  sqlite3_db_config(connection.handle(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_limit(connection.handle(), SQLITE_LIMIT_ATTACHED, 0);
  return connection;
}

/// A database of an older version lacks columns and views that people read of.
[[noreturn]] void fail_to_prepare(const Connection& connection, int code, const std::string& sql) {
  const std::string why = sqlite3_errmsg(connection.handle()) + std::string(" (SQLite ") + std::to_string(code) + ")";
  const int version = stored_schema_version(connection);
  if (version == schema_version) throw StorageError(error_kind(code), connection.path() + ": " + sql + ": " + why);
  throw StorageError(error_kind(code),
                     connection.path() + ": " + sql + ": " + why + "; the database " + older_schema_text(version));
}

/// Throws unless the text is one statement that only reads and has columns.
Statement prepare_query(const Connection& connection, const std::string& sql) {
  const auto refuse = [&](const std::string& why) {
    throw StorageError(Kind::input_output, connection.path() + ": " + why + ": " + sql);
  };
  sqlite3_stmt* first = nullptr;
  const char* rest = nullptr;
  int code = sqlite3_prepare_v2(connection.handle(), sql.c_str(), -1, &first, &rest);
  const bool one = first != nullptr;
  const bool reads = one && sqlite3_stmt_readonly(first) != 0 && sqlite3_column_count(first) > 0;
  sqlite3_finalize(first);
  if (code != SQLITE_OK) fail_to_prepare(connection, code, sql);
  if (!one) refuse("no statement");
  if (!reads) refuse("not a query: only statements that read are allowed");
  sqlite3_stmt* second = nullptr;
  code = sqlite3_prepare_v2(connection.handle(), rest, -1, &second, nullptr);
  const bool more = second != nullptr || code != SQLITE_OK;
  sqlite3_finalize(second);
  if (more) refuse("more than one statement");
  return {connection, sql};
}

}  // namespace

struct ResultsReader::Implementation {
  explicit Implementation(const std::string& path) : connection(open_for_queries(path)) {}
  Connection connection;
};

ResultsReader::ResultsReader(const std::string& path) : implementation_(std::make_unique<Implementation>(path)) {}
ResultsReader::~ResultsReader() = default;
ResultsReader::ResultsReader(ResultsReader&&) noexcept = default;
ResultsReader& ResultsReader::operator=(ResultsReader&&) noexcept = default;

experiment::Id128 ResultsReader::database_id() const {
  return read_database_row(implementation_->connection).id;
}

std::uint32_t ResultsReader::science_version() const {
  return read_database_row(implementation_->connection).science_version;
}

std::vector<Sweep> ResultsReader::sweeps() const {
  return read_sweeps(implementation_->connection);
}

std::optional<Sweep> ResultsReader::find_sweep(const std::string& name_or_id) const {
  const auto& connection = implementation_->connection;
  if (auto by_name = find_sweep_by(connection, "name", std::string_view(name_or_id))) return by_name;
  return find_sweep_by(connection, "id", std::string_view(name_or_id));
}

std::optional<EndedJob> ResultsReader::job(std::int64_t sweep, std::uint64_t job) const {
  const auto& connection = implementation_->connection;
  Statement find(connection,
                 "SELECT " + job_columns(stored_schema_version(connection)) + " FROM job WHERE sweep = ? AND job = ?");
  find.with(sweep, job);
  if (!find.step()) return std::nullopt;
  auto stored = read_job_row(find);
  if (!stored.malformed.empty()) {
    const auto& wrong = stored.malformed.front();
    throw StorageError(Kind::corrupt, implementation_->connection.path() + ": sweep " + std::to_string(sweep) +
                                          ", job " + std::to_string(job) + ", column " + wrong.column + ": " +
                                          wrong.text);
  }
  return std::move(stored.job);
}

std::optional<std::string> ResultsReader::build_of(std::uint64_t worker) const {
  return find_build(implementation_->connection, worker);
}

ResultsReader::Table ResultsReader::results(const std::string& sweep_name, std::uint64_t first_job,
                                            std::uint64_t limit) const {
  Statement select(implementation_->connection,
                   "SELECT * FROM result WHERE sweep = ? AND job >= ? ORDER BY job LIMIT ?");
  select.with(std::string_view(sweep_name), first_job, limit);
  return read_table(select);
}

ResultsReader::Table ResultsReader::query(const std::string& sql) const {
  Statement statement = prepare_query(implementation_->connection, sql);
  return read_table(statement);
}

}  // namespace lamprey::storage
