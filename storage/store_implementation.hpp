#pragma once

#include "storage/batch_writer.hpp"
#include "storage/connection.hpp"
#include "storage/exclusive_lock.hpp"
#include "storage/results_store.hpp"
#include "storage/statement.hpp"

#include <string>

namespace lamprey::storage {

/// What opening for writing changes.
struct Opening {
  std::uint64_t epoch = 0;
  std::string migration;
};

/// What the functions of a ResultsStore share.
struct ResultsStore::Implementation {
  Implementation(const std::string& database_path, const StoreOptions& options);

  /// Runs the action in a write transaction, commits it and returns what it returned. Nothing is stored if it throws.
  template <typename Action>
  auto write(const Action& action) {
    Transaction transaction(connection, Transaction::Mode::write);
    auto result = action();
    transaction.commit();
    bound_log();
    return result;
  }

  /// The sweep; throws not_possible if it does not exist or, so that nothing changes that is going, is being deleted.
  Sweep changeable_sweep(std::int64_t sweep) const;

  /// Copies the log into the database where it has grown enough.
  void bound_log();

  std::string path;
  ExclusiveLock lock;  // before the connection: taken earlier, released later
  Connection connection;
  Opening opening;
  experiment::Id128 database_id;
  BatchWriter writer;
  Statement find_job;
  Statement read_job;
  int log_pages = 0;
  int next_wait_pages = 0;
  bool held_by_reader = false;
};

/// The numbers in the first column of the rows, which must ascend.
experiment::JobRanges read_ranges(Statement& numbers);

}  // namespace lamprey::storage
