#include "storage/database_file.hpp"
#include "storage/schema.hpp"
#include "storage/sweep_row.hpp"
#include "storage/verify_parts.hpp"

namespace lamprey::storage {

namespace {

/// How many rows lie between two calls of the progress function.
constexpr std::uint64_t progress_rows = 1000;

/// Its rows are in order by the rules of their time, which this program no longer knows.
void refuse_older_schema(const Connection& connection) {
  const int stored = stored_schema_version(connection);
  if (stored == schema_version) return;
  throw StorageError(StorageError::Kind::older_schema,
                     connection.path() + ": " + older_schema_text(stored) + "; only then can it be verified");
}

void refuse_other_science(const Connection& connection) {
  const auto stored = read_database_row(connection).science_version;
  if (stored == experiment::science_version) return;
  throw StorageError(StorageError::Kind::other_science,
                     connection.path() + ": holds outcomes of science version " + std::to_string(stored) +
                         ", this program can only check those of " + std::to_string(experiment::science_version) +
                         ": check it with the Lamprey that wrote it");
}

void verify_pages(const Connection& connection, std::vector<Discrepancy>& discrepancies) {
  Statement check(connection, "PRAGMA integrity_check");
  while (check.step()) {
    if (check.text(0) != "ok") {
      discrepancies.push_back({"", std::nullopt, "", "SQLite's integrity check: " + std::string(check.text(0))});
    }
  }
}

/// The text with each run of blanks and line ends as one blank, and none before a comma or parenthesis: SQLite puts a
/// column that is added later on the line of the one before.
std::string one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n';
    const bool after_blank = !line.empty() && line.back() == ' ';
    if (blank && after_blank) continue;
    if ((c == ',' || c == ')') && after_blank) line.pop_back();
    line += blank ? ' ' : c;
  }
  return line;
}

/// Tables as this schema version has them; views and descriptions as the program that made them left them.
void verify_schema(const Connection& connection, std::vector<Discrepancy>& discrepancies) {
  Statement find(connection, "SELECT sql FROM sqlite_master WHERE type = 'table' AND name = ?");
  for (const auto& table : tables()) {
    find.bind(1, std::string_view(table.name));
    if (!find.step() || one_line(find.text(0)) != one_line(table_sql(table))) {
      discrepancies.push_back({"", std::nullopt, "", "the definition of the table " + table.name + " is not ours"});
    }
    find.reset();
  }
  Statement fingerprint(connection, "SELECT fingerprint FROM database");
  const auto expected = stored_schema_fingerprint(connection);
  if (!fingerprint.step() || fingerprint.text(0) != expected) {
    discrepancies.push_back({"", std::nullopt, "fingerprint", "a view or its description has been changed"});
  }
}

class Verifier {
 public:
  Verifier(const Connection& connection, Verification& result, const std::function<void(std::uint64_t)>& progress)
      : connection_(connection), result_(result), progress_(progress) {}

  void run() {
    verify_pages(connection_, result_.discrepancies);
    verify_schema(connection_, result_.discrepancies);
    verify_references(connection_, result_.discrepancies);
    verify_audits(connection_, result_.discrepancies);
    verify_recordings(connection_, result_.discrepancies);
    for (const auto& sweep : read_sweeps(connection_)) {
      const auto grid = verify_sweep(connection_, sweep, result_.discrepancies);
      verify_jobs(sweep, grid ? &*grid : nullptr);
    }
    if (progress_) progress_(result_.jobs);
  }

 private:
  void verify_jobs(const Sweep& sweep, const experiment::SweepGrid* grid) {
    Statement rows(connection_, "SELECT " + job_columns() + " FROM job WHERE sweep = ? ORDER BY job");
    Statement sources(connection_, "SELECT identity, digest FROM job WHERE sweep = ? AND job = ?");
    rows.bind(1, sweep.row);
    while (rows.step()) {
      const auto stored = read_job_row(rows);
      verify_job(stored, sweep.what.name, grid, result_.discrepancies);
      if (stored.job.reused_from) verify_source(stored.job, sweep.what.name, sources, result_.discrepancies);
      if (stored.job.outcome) result_.trace_rows += stored.job.outcome->trace.size();
      if (++result_.jobs % progress_rows == 0 && progress_) progress_(result_.jobs);
    }
  }

  const Connection& connection_;
  Verification& result_;
  const std::function<void(std::uint64_t)>& progress_;
};

}  // namespace

Verification verify(const std::string& path, const std::function<void(std::uint64_t)>& progress) {
  const Connection connection = open_existing(path);
  Verification result;
  // One transaction: counters and rows of one moment, also while a coordinator writes.
  Transaction transaction(connection, Transaction::Mode::read);
  refuse_older_schema(connection);
  refuse_other_science(connection);
  try {
    Verifier(connection, result, progress).run();
  } catch (const StorageError& error) {
    // Damage that keeps SQLite from reading on is a finding, too.
    if (error.kind() != StorageError::Kind::corrupt) throw;
    result.discrepancies.push_back({"", std::nullopt, "", error.what()});
  }
  return result;
}

}  // namespace lamprey::storage
