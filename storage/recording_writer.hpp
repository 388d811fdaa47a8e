#pragma once

#include "storage/recording_row.hpp"
#include "storage/results_store.hpp"
#include "storage/statement.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace lamprey::storage {

/// Writes what robots recorded, as Batch::recordings says. The caller holds the transaction; after an exception it must
/// roll back. Throws StorageError. Not thread-safe.
class RecordingWriter {
 public:
  explicit RecordingWriter(const Connection& connection);

  void write(const RecordedAttempt& attempt, std::int64_t now);

 private:
  TryRow row_of(const RobotTry& tried);

  const Connection& connection_;
  Statement insert_recording_;
  Statement insert_evaluation_;
  std::array<std::string, 3> texts_;  ///< of a try's lists; kept for their memory
};

}  // namespace lamprey::storage
