#include "storage/sweep_row.hpp"

#include <utility>

namespace lamprey::storage {

namespace {

std::optional<SweepState> sweep_state(std::string_view text) {
  for (const auto state : {SweepState::running, SweepState::paused, SweepState::finished, SweepState::cancelling,
                           SweepState::cancelled, SweepState::deleting}) {
    if (to_text(state) == text) return state;
  }
  return std::nullopt;
}

}  // namespace

std::string sweep_columns(int version) {
  const std::string columns =
      "sweep, id, name, specification, source, seed, replicates, jobs, science_version, state, "
      "done, failed, quarantined, cancelled, divergences, created, ended, ";
  return columns + (version < first_version_with_execution ? "0 AS reused, 0 AS audited, 0 AS fresh, 0 AS archived, "
                                                             "NULL AS reason, X'' AS execution"
                                                           : "reused, audited, fresh, archived, reason, execution");
}

Sweep read_sweep_row(const Statement& row, const std::string& path) {
  const auto refuse = [&](const std::string& why) {
    throw StorageError(StorageError::Kind::corrupt,
                       path + ": row " + std::to_string(row.integer(0)) + " of the table sweep: " + why);
  };
  const auto whole_32 = [&](int column) {
    if (!std::in_range<std::uint32_t>(row.integer(column))) {
      refuse(std::string(row.name(column)) + " " + std::to_string(row.integer(column)) + " is out of range");
    }
    return static_cast<std::uint32_t>(row.integer(column));
  };
  const auto id = experiment::id128_from_hex(row.text(1));
  if (!id) refuse("'" + std::string(row.text(1)) + "' is not an id");
  const auto state = sweep_state(row.text(9));
  if (!state) refuse("'" + std::string(row.text(9)) + "' is not a state");
  Sweep sweep;
  sweep.row = row.integer(0);
  sweep.what.id = *id;
  sweep.what.name = row.text(2);
  const auto specification = row.blob(3);
  sweep.what.specification.assign(specification.begin(), specification.end());
  sweep.what.source = row.text(4);
  sweep.what.seed = row.bits(5);
  sweep.what.replicates = whole_32(6);
  sweep.what.jobs = row.bits(7);
  sweep.science_version = whole_32(8);
  sweep.state = *state;
  sweep.counts = {row.bits(10), row.bits(11), row.bits(12), row.bits(13)};
  sweep.divergences = row.bits(14);
  sweep.created_unix_milliseconds = row.integer(15);
  if (!row.is_null(16)) sweep.ended_unix_milliseconds = row.integer(16);
  sweep.reused = row.bits(17);
  sweep.audited = row.bits(18);
  sweep.what.fresh = row.integer(19) != 0;
  sweep.archived = row.integer(20) != 0;
  sweep.reason = row.text(21);
  const auto execution = row.blob(22);
  sweep.what.execution.assign(execution.begin(), execution.end());
  return sweep;
}

std::vector<Sweep> read_sweeps(const Connection& connection) {
  Statement all(connection,
                "SELECT " + sweep_columns(stored_schema_version(connection)) + " FROM sweep ORDER BY sweep");
  std::vector<Sweep> sweeps;
  while (all.step()) sweeps.push_back(read_sweep_row(all, connection.path()));
  return sweeps;
}

experiment::Digest sweep_checksum(const NewSweep& sweep, std::uint32_t science_version) {
  // Each text with its length before it, so that no two sweeps give the same bytes.
  std::string text = "lamprey sweep row 1\n" + experiment::to_hex(sweep.id) + '\n';
  for (const auto* part : {&sweep.name, &sweep.specification, &sweep.source}) {
    text += std::to_string(part->size()) + '\n' + *part + '\n';
  }
  for (const std::uint64_t number :
       {sweep.seed, std::uint64_t{sweep.replicates}, sweep.jobs, std::uint64_t{science_version}}) {
    text += std::to_string(number) + '\n';
  }
  if (sweep.fresh) text += "fresh\n";
  if (!sweep.execution.empty()) {
    text += "execution\n" + std::to_string(sweep.execution.size()) + '\n' + sweep.execution + '\n';
  }
  return experiment::sha256(text);
}

std::optional<std::string> find_build(const Connection& connection, std::uint64_t worker) {
  Statement find(connection, "SELECT build FROM worker WHERE worker = ?");
  find.bind(1, worker);
  if (!find.step()) return std::nullopt;
  return std::string(find.text(0));
}

DatabaseRow read_database_row(const Connection& connection) {
  Statement read(connection, "SELECT database_id, science_version, epoch FROM database WHERE row = 1");
  const bool found = read.step();
  const auto id = found ? experiment::id128_from_hex(read.text(0)) : std::nullopt;
  if (!id)
    throw StorageError(StorageError::Kind::corrupt, connection.path() + ": the table 'database' has no valid row");
  return {*id, static_cast<std::uint32_t>(read.integer(1)), read.bits(2)};
}

}  // namespace lamprey::storage
