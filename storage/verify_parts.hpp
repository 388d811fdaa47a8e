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

/// Checks a reused row against the one whose outcome it has, where that still exists; `find` selects identity and
/// digest of a sweep's job.
void verify_source(const EndedJob& job, const std::string& sweep_name, Statement& find,
                   std::vector<Discrepancy>& discrepancies);

/// Rows that no sweep's check would meet, or that contradict the job's row.
void verify_references(const Connection& connection, std::vector<Discrepancy>& discrepancies);

/// Audits against the jobs that they have computed again.
void verify_audits(const Connection& connection, std::vector<Discrepancy>& discrepancies);

/// What robots recorded, against itself and the jobs' rows.
void verify_recordings(const Connection& connection, std::vector<Discrepancy>& discrepancies);

/// Adds a discrepancy for each row of the query: the sweep's name or key, the job or NULL, and what is wrong.
void add_rows(const Connection& connection, const std::string& sql, const std::string& column,
              std::vector<Discrepancy>& discrepancies);

/// "stored …, expected …"
std::string stored_and_expected(const std::string& stored, const std::string& expected);

}  // namespace lamprey::storage
