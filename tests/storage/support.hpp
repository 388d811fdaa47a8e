#pragma once

#include "experiment/sweep.hpp"
#include "storage/connection.hpp"
#include "storage/results_reader.hpp"
#include "storage/results_store.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace lamprey::storage::testing {

/// A directory of its own for each test, removed with what is in it.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// A sweep and what its jobs are.
struct SweepCase {
  idl::SweepSpecification specification;
  experiment::SweepGrid grid;
  NewSweep what;
};

/// mutation × steps × acceptance, `replicates` times: 18 jobs each.
SweepCase operator_sweep(const std::string& name, std::uint32_t replicates = 1);

/// robot (bridge, quadruped) × mutation (all, one) × acceptance (simple, annealing): jobs 0 to 3 are on a robot, 4 to 7
/// their simulations.
SweepCase robot_sweep(const std::string& name);

/// What a robot may have recorded in three tries, the same for the same number: evaluation 0 twice, void after one time
/// step and then whole, and evaluation 1.
RobotRecording made_up_recording(std::uint64_t number);

/// Any specification.
SweepCase sweep_case(const idl::SweepSpecification& specification, const std::string& source = "");

/// An outcome of the kind that a run gives, the same for the same number; `rows` accepted changes.
experiment::Outcome made_up_outcome(std::uint64_t number, std::uint32_t rows = 5);

/// The job of that number as done, with that outcome.
EndedJob done_job(const SweepCase& sweep, std::int64_t row, std::uint64_t number, const experiment::Outcome& outcome);
EndedJob done_job(const SweepCase& sweep, std::int64_t row, std::uint64_t number);

/// The job as one that ended without an outcome.
EndedJob ended_job(const SweepCase& sweep, std::int64_t row, std::uint64_t number, JobState state,
                   const std::string& reason = "");

/// A plain connection to the file, as a user's program would have.
Connection raw_connection(const std::string& path);

/// The values of the first column of a query, as JSON literals.
std::vector<std::string> column_of(const ResultsReader& reader, const std::string& sql);

/// The one value of a query.
std::string value_of(const ResultsReader& reader, const std::string& sql);

/// The content of a file; empty if there is none.
std::string bytes_of(const std::string& path);
void write_bytes(const std::string& path, const std::string& bytes);

/// The discrepancies, a line each.
std::string text_of(const Verification& verification);

/// The kind of the StorageError that `action` throws, and its text in `message`; nothing if it throws none.
template <typename Action>
std::optional<StorageError::Kind> error_of(const Action& action, std::string* message = nullptr) {
  try {
    action();
  } catch (const StorageError& error) {
    if (message != nullptr) *message = error.what();
    return error.kind();
  }
  return std::nullopt;
}

}  // namespace lamprey::storage::testing
