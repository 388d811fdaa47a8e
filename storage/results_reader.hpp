#pragma once

#include "storage/results_store.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamprey::storage {

/// Reads a results database, also while a coordinator writes it; changes nothing and takes no lock that would stop the
/// writer. Not thread-safe. Every function throws StorageError.
class ResultsReader {
 public:
  /// Refuses what is not a Lamprey database, is of a newer schema, or does not exist.
  explicit ResultsReader(const std::string& path);
  ~ResultsReader();
  ResultsReader(ResultsReader&&) noexcept;
  ResultsReader& operator=(ResultsReader&&) noexcept;

  experiment::Id128 database_id() const;
  std::uint32_t science_version() const;

  std::vector<Sweep> sweeps() const;
  /// By name or by id in hex.
  std::optional<Sweep> find_sweep(const std::string& name_or_id) const;

  /// A job with its row as stored; nothing if it has none.
  std::optional<EndedJob> job(std::int64_t sweep, std::uint64_t job) const;

  /// The build that a worker reported; nothing if it has no row.
  std::optional<std::string> build_of(std::uint64_t worker) const;

  /// Rows of any view or query, as JSON literals (numbers, strings in quotes, null). One statement, read-only.
  struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
  };
  /// Columns of `result` for the sweep, jobs from first_job on, at most `limit` rows.
  Table results(const std::string& sweep_name, std::uint64_t first_job, std::uint64_t limit) const;
  Table query(const std::string& sql) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// What verify found wrong: where, and what is stored against what follows from the rest.
struct Discrepancy {
  std::string sweep;
  std::optional<std::uint64_t> job;
  std::string column;
  std::string text;
};

struct Verification {
  std::uint64_t jobs = 0;  ///< rows checked
  std::uint64_t trace_rows = 0;
  std::vector<Discrepancy> discrepancies;
};

/// Recomputes from the *stored* values whatever can be recomputed: each job's digest from its columns and trace, its
/// identity, parameters, seed and replicate from the sweep's specification, the sweep's id from its specification, the
/// counters from the rows; and runs SQLite's own integrity check. One flipped byte in any deterministic column or trace
/// is found. `progress` is called now and then with the number of rows done.
Verification verify(const std::string& path, const std::function<void(std::uint64_t)>& progress = {});

}  // namespace lamprey::storage
