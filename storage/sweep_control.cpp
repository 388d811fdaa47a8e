#include "storage/schema.hpp"
#include "storage/store_implementation.hpp"
#include "storage/sweep_row.hpp"

namespace lamprey::storage {

namespace {

using Kind = StorageError::Kind;

/// The columns of the sweep that its checksum covers and that may change, with the checksum.
void update_checked_columns(const Connection& connection, const Sweep& sweep) {
  const auto checksum = sweep_checksum(sweep.what, sweep.science_version);
  const std::span execution(reinterpret_cast<const std::uint8_t*>(sweep.what.execution.data()),
                            sweep.what.execution.size());
  Statement(connection, "UPDATE sweep SET name = ?, execution = ?, checksum = ? WHERE sweep = ?")
      .with(std::string_view(sweep.what.name), execution, std::span<const std::uint8_t>(checksum), sweep.row)
      .run();
}

/// Which states' rows a retry takes back, as an SQL list.
std::string retried_states(bool cancelled_too) {
  return std::string("('failed', 'quarantined'") + (cancelled_too ? ", 'cancelled')" : ")");
}

/// Makes attempts of the rows in those states. `?1` of each statement is the sweep.
void turn_into_attempts(const Connection& connection, std::int64_t sweep, const std::string& states) {
  const std::string rows = " FROM job WHERE sweep = ?1 AND state IN " + states;
  for (const auto& sql :
       {"UPDATE attempt SET counted = 0 WHERE sweep = ?1 AND counted = 1 AND job IN (SELECT job" + rows + ")",
        "INSERT INTO attempt (at, sweep, job, worker, ending, counted, reason) "
        "SELECT ended, sweep, job, worker, state, 0, coalesce(reason, '')" +
            rows + " ORDER BY job",
        "DELETE" + rows}) {
    Statement(connection, sql).with(sweep).run();
  }
}

}  // namespace

void ResultsStore::rename(std::int64_t sweep, const std::string& name) {
  const auto& connection = implementation_->connection;
  auto stored = implementation_->changeable_sweep(sweep);
  if (stored.what.name == name) return;
  if (const auto other = find_sweep_by(connection, "name", std::string_view(name))) {
    throw StorageError(Kind::name_taken, path() + ": another sweep has the name '" + name + "' (id " +
                                             experiment::to_hex(other->what.id) + ")");
  }
  const std::string text = stored.what.name + " is now " + name;
  stored.what.name = name;
  implementation_->write([&] {
    update_checked_columns(connection, stored);
    implementation_->writer.write(Event{"sweep_renamed", sweep, {}, 0, text});
    return true;
  });
}

void ResultsStore::set_archived(std::int64_t sweep, bool archived) {
  const auto stored = implementation_->changeable_sweep(sweep);
  if (stored.archived == archived) return;
  implementation_->write([&] {
    Statement(implementation_->connection, "UPDATE sweep SET archived = ? WHERE sweep = ?").with(archived, sweep).run();
    implementation_->writer.write(
        Event{archived ? "sweep_archived" : "sweep_unarchived", sweep, {}, 0, stored.what.name});
    return true;
  });
}

void ResultsStore::set_execution(std::int64_t sweep, const std::string& execution) {
  auto stored = implementation_->changeable_sweep(sweep);
  if (stored.what.execution == execution) return;
  stored.what.execution = execution;
  implementation_->write([&] {
    update_checked_columns(implementation_->connection, stored);
    implementation_->writer.write(Event{"execution_changed", sweep, {}, 0, stored.what.name});
    return true;
  });
}

experiment::JobRanges ResultsStore::retry(std::int64_t sweep, bool cancelled_too) {
  const auto& connection = implementation_->connection;
  const auto stored = implementation_->changeable_sweep(sweep);
  if (stored.state == SweepState::cancelling) {
    throw StorageError(Kind::not_possible, path() + ": the sweep '" + stored.what.name +
                                               "' is being cancelled; its jobs can be retried when that has ended");
  }
  const auto states = retried_states(cancelled_too);
  Statement numbers(connection, "SELECT job FROM job WHERE sweep = ? AND state IN " + states + " ORDER BY job");
  auto jobs = read_ranges(numbers.with(sweep));
  numbers.reset();
  if (jobs.empty()) return jobs;
  implementation_->write([&] {
    turn_into_attempts(connection, sweep, states);
    Statement(connection,
              "UPDATE sweep SET state = CASE state WHEN 'paused' THEN state ELSE 'running' END, ended = NULL, "
              "reason = CASE state WHEN 'paused' THEN reason END, failed = 0, quarantined = 0, "
              "cancelled = CASE WHEN ?2 THEN 0 ELSE cancelled END WHERE sweep = ?1")
        .with(sweep, cancelled_too)
        .run();
    implementation_->writer.write(
        Event{"jobs_retried", sweep, {}, 0, stored.what.name + ": " + std::to_string(jobs.size()) + " jobs"});
    return true;
  });
  return jobs;
}

void ResultsStore::set_draining(std::uint64_t worker, bool draining) {
  const auto& connection = implementation_->connection;
  implementation_->write([&] {
    Statement(connection, "UPDATE worker SET draining = ?2 WHERE worker = ?1 AND draining <> ?2")
        .with(worker, draining)
        .run();
    if (sqlite3_changes(connection.handle()) > 0) {
      implementation_->writer.write(
          Event{draining ? "worker_draining" : "worker_drained", {}, {}, worker, draining ? "takes nothing more" : ""});
    } else if (draining && !find_build(connection, worker)) {
      throw StorageError(Kind::not_possible, path() + ": there is no worker with the key " +
                                                 std::to_string(static_cast<std::int64_t>(worker)));
    }
    return true;
  });
}

std::vector<std::uint64_t> ResultsStore::draining() const {
  Statement workers(implementation_->connection, "SELECT worker FROM worker WHERE draining = 1");
  std::vector<std::uint64_t> draining;
  while (workers.step()) draining.push_back(workers.bits(0));
  return draining;
}

}  // namespace lamprey::storage
