#include "storage/schema.hpp"
#include "storage/store_implementation.hpp"

namespace lamprey::storage {

namespace {

/// Audits that the rest of the statement selects, in order.
std::vector<Audit> read_audits(const Connection& connection, const std::string& rest) {
  Statement rows(connection, "SELECT audit, id, sweep, share, seed, jobs, agreed, diverged FROM audit " + rest);
  std::vector<Audit> audits;
  while (rows.step()) {
    const auto id = experiment::id128_from_hex(rows.text(1));
    if (!id) {
      throw StorageError(StorageError::Kind::corrupt, connection.path() + ": row " + std::to_string(rows.integer(0)) +
                                                          " of the table audit: '" + std::string(rows.text(1)) +
                                                          "' is not an id");
    }
    audits.push_back(
        {rows.integer(0), *id, rows.integer(2), rows.real(3), rows.bits(4), rows.bits(5), rows.bits(6), rows.bits(7)});
  }
  return audits;
}

}  // namespace

Audit ResultsStore::add_audit(const Audit& audit) {
  const auto& connection = implementation_->connection;
  const std::string id = experiment::to_hex(audit.id);
  const auto stored = [&] { return read_audits(connection, "WHERE id = '" + id + "'"); };
  if (auto existing = stored(); !existing.empty()) return existing.front();
  const auto sweep = implementation_->changeable_sweep(audit.sweep);
  return implementation_->write([&] {
    Statement(connection, "INSERT INTO audit (id, sweep, share, seed, jobs, created) VALUES (?, ?, ?, ?, ?, ?)")
        .with(std::string_view(id), audit.sweep, audit.share, audit.seed, audit.jobs, unix_milliseconds())
        .run();
    implementation_->writer.write(
        Event{"audit_started", audit.sweep, {}, 0, sweep.what.name + ": " + std::to_string(audit.jobs) + " jobs"});
    return stored().front();
  });
}

std::vector<Audit> ResultsStore::audits() const {
  return read_audits(implementation_->connection, "ORDER BY audit");
}

experiment::JobRanges ResultsStore::audited_jobs(std::int64_t audit) const {
  Statement numbers(implementation_->connection, "SELECT job FROM audit_job WHERE audit = ? ORDER BY job");
  return read_ranges(numbers.with(audit));
}

}  // namespace lamprey::storage
