#include "storage/store_implementation.hpp"
#include "storage/sweep_row.hpp"

#include <algorithm>

namespace lamprey::storage {

namespace {

/// Deletes rows of one sweep, up to a number of them.
class Deletion {
 public:
  Deletion(const Connection& connection, std::int64_t sweep, std::uint64_t most)
      : connection_(connection), sweep_(sweep), left_(most) {}

  /// Whether rows may be left: then nothing that they refer to can go yet.
  bool exhausted() const { return left_ == 0; }

  /// Runs a statement of which `?1` is the sweep and `?2` how many rows it may change. Its rows are those changed, and
  /// `see` is called for each.
  template <typename See>
  void run(const std::string& sql, const See& see) {
    if (exhausted()) return;
    Statement statement(connection_, sql);
    statement.with(sweep_, left_);
    std::uint64_t changed = 0;
    for (; statement.step(); ++changed) see(statement);
    left_ -= changed;
  }
  void run(const std::string& sql) {
    run(sql, [](const Statement&) {});
  }

 private:
  const Connection& connection_;
  std::int64_t sweep_;
  std::uint64_t left_;
};

std::string delete_rows(const std::string& table) {
  return "DELETE FROM " + table + " WHERE rowid IN (SELECT rowid FROM " + table +
         " WHERE sweep = ?1 LIMIT ?2) RETURNING 1";
}

/// What refers to the sweep or contradicts its jobs; its jobs remain.
void delete_around_jobs(const Connection& connection, Deletion& deletion, const Sweep& sweep) {
  deletion.run(
      "DELETE FROM audit_job WHERE rowid IN (SELECT rowid FROM audit_job WHERE audit IN "
      "(SELECT audit FROM audit WHERE sweep = ?1) LIMIT ?2) RETURNING 1");
  deletion.run(
      "DELETE FROM robot_evaluation WHERE rowid IN (SELECT e.rowid FROM recording AS r "
      "JOIN robot_evaluation AS e ON e.recording = r.recording WHERE r.sweep = ?1 LIMIT ?2) RETURNING 1");
  for (const auto* table : {"audit", "attempt", "checkpoint", "recording"}) deletion.run(delete_rows(table));
  std::uint64_t divergences = 0;
  deletion.run(delete_rows("divergence"), [&](const Statement&) { ++divergences; });
  Statement(connection, "UPDATE sweep SET audited = 0, divergences = divergences - ?2 WHERE sweep = ?1")
      .with(sweep.row, divergences)
      .run();
  const std::string name = "(SELECT name FROM sweep WHERE sweep = ?1)";
  deletion.run("UPDATE event SET sweep = NULL, text = CASE WHEN instr(text, " + name + ") THEN text ELSE " + name +
               " || ': ' || text END WHERE event IN (SELECT event FROM event WHERE sweep = ?1 LIMIT ?2) RETURNING 1");
}

void delete_jobs(const Connection& connection, Deletion& deletion, std::int64_t sweep) {
  JobCounts gone;
  std::uint64_t reused = 0;
  deletion.run(
      "DELETE FROM job WHERE rowid IN (SELECT rowid FROM job WHERE sweep = ?1 LIMIT ?2) "
      "RETURNING state, reused_from_job",
      [&](const Statement& row) {
        const auto state = row.text(0);
        ++(state == "done"          ? gone.done
           : state == "failed"      ? gone.failed
           : state == "quarantined" ? gone.quarantined
                                    : gone.cancelled);
        if (!row.is_null(1)) ++reused;
      });
  // In one statement: reused is never larger than done.
  Statement(connection,
            "UPDATE sweep SET done = done - ?2, failed = failed - ?3, quarantined = quarantined - ?4, "
            "cancelled = cancelled - ?5, reused = reused - ?6 WHERE sweep = ?1")
      .with(sweep, gone.done, gone.failed, gone.quarantined, gone.cancelled, reused)
      .run();
}

}  // namespace

bool ResultsStore::delete_some(std::int64_t sweep, std::uint64_t most) {
  const auto& connection = implementation_->connection;
  const auto stored = find_sweep_by(connection, "sweep", sweep);
  if (!stored) return true;
  if (stored->state != SweepState::deleting) {
    throw StorageError(StorageError::Kind::not_possible, path() + ": the sweep '" + stored->what.name + "' is " +
                                                             to_text(stored->state) +
                                                             ": only one in state deleting is deleted");
  }
  return implementation_->write([&] {
    Deletion deletion(connection, sweep, std::max<std::uint64_t>(most, 1));
    delete_around_jobs(connection, deletion, *stored);
    delete_jobs(connection, deletion, sweep);
    if (deletion.exhausted()) return false;
    Statement(connection, "DELETE FROM sweep WHERE sweep = ?").with(sweep).run();
    implementation_->writer.write(Event{"sweep_deleted", {}, {}, 0, stored->what.name});
    return true;
  });
}

}  // namespace lamprey::storage
