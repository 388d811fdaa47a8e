#pragma once

#include "experiment/sweep.hpp"
#include "storage/connection.hpp"
#include "storage/job_row.hpp"
#include "storage/results_reader.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lamprey::storage {

/// Checks a sweep's own columns against its specification, its checksum, its rows and each other. Returns the grid that
/// its jobs are checked against, or nothing if the specification cannot be used.
std::optional<experiment::SweepGrid> verify_sweep(const Connection& connection, const Sweep& sweep,
                                                  std::vector<Discrepancy>& discrepancies);

/// Checks one row against the sweep's grid, if there is one, and against itself.
void verify_job(const StoredJobRow& stored, const std::string& sweep_name, const experiment::SweepGrid* grid,
                std::vector<Discrepancy>& discrepancies);

/// "stored …, expected …"
std::string stored_and_expected(const std::string& stored, const std::string& expected);

}  // namespace lamprey::storage
