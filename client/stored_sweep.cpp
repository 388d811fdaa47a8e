#include "client/stored_sweep.hpp"

#include "client/failure.hpp"
#include "experiment/specification_difference.hpp"
#include "storage/results_reader.hpp"

#include <filesystem>

namespace lamprey::client {

std::optional<messaging::SweepProgress> stored_sweep(const std::string& database, const SweepInput& sweep) {
  std::error_code error;
  // A coordinator makes a database of a file that is missing or empty.
  if (const auto size = std::filesystem::file_size(database, error);
      error == std::errc::no_such_file_or_directory || (!error && size == 0)) {
    return std::nullopt;
  }
  const storage::ResultsReader reader(database);
  if (const auto named = reader.find_sweep(sweep.name()); named && named->what.id != sweep.id) {
    idl::SweepSpecification stored;
    stored.ParseFromString(named->what.specification);
    throw sweep_changed(sweep.name(), experiment::differences(stored, sweep.file.specification));
  }
  const auto found = reader.find_sweep(experiment::to_hex(sweep.id));
  if (!found || found->science_version != experiment::science_version) return std::nullopt;
  messaging::SweepProgress progress;
  progress.sweep = found->what.id;
  progress.name = found->what.name;
  progress.state = storage::to_text(found->state);
  progress.jobs = found->what.jobs;
  progress.done = found->counts.done;
  progress.failed = found->counts.failed;
  progress.quarantined = found->counts.quarantined;
  progress.cancelled = found->counts.cancelled;
  progress.pending = found->what.jobs - found->counts.ended();
  progress.divergences = found->divergences;
  return progress;
}

}  // namespace lamprey::client
