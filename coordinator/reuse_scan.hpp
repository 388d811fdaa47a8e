#pragma once

#include "experiment/job_ranges.hpp"
#include "experiment/sweep.hpp"
#include "storage/results_store.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace lamprey::coordinator {

/// Looks for outcomes of a new sweep's jobs among those that the database has from other sweeps, a little at a time:
/// the coordinator has other things to do. Only bitwise repeatable jobs are taken: for them the same identity means the
/// same outcome. Memory is proportional to the stored jobs of the same seed, and freed with the scan.
class ReuseScan {
 public:
  /// `open_jobs`: without a row.
  ReuseScan(const storage::Sweep& sweep, std::shared_ptr<const experiment::SweepGrid> grid,
            experiment::JobRanges open_jobs);

  /// Whether any stored outcome can be of use; if not, there is nothing to scan.
  static bool worth_while(const storage::ResultsStore& store, const storage::Sweep& sweep);

  /// Not looked at yet.
  const experiment::JobRanges& open_jobs() const { return open_jobs_; }

  struct Found {
    std::vector<storage::EndedJob> rows;  ///< to be stored for this sweep
    experiment::JobRanges to_compute;     ///< looked at, and not found
    bool finished = false;
  };
  /// Throws StorageError, and may then be called again.
  Found step(const storage::ResultsStore& store);

 private:
  struct Hash {
    std::size_t operator()(const experiment::Digest& digest) const;
  };
  void read_identities(const storage::ResultsStore& store);
  std::optional<storage::EndedJob> reused(const storage::ResultsStore& store, const experiment::Job& job) const;

  storage::Sweep sweep_;
  std::shared_ptr<const experiment::SweepGrid> grid_;
  experiment::JobRanges open_jobs_;
  bool all_read_ = false;
  storage::ResultsStore::Place place_;
  std::unordered_map<experiment::Digest, storage::ResultsStore::Place, Hash> known_;
};

}  // namespace lamprey::coordinator
