#pragma once

#include "experiment/identifiers.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lamprey::storage {

/// The columns of `recording` that its checksum covers.
struct RecordingRow {
  std::int64_t sweep = 0;
  std::uint64_t job = 0;
  std::optional<std::uint64_t> worker;
  std::string robot;
  std::uint64_t token = 0;
  std::string state;
  bool accepted = false;
};

/// A row of `robot_evaluation` without its key. The texts are the caller's.
struct TryRow {
  std::uint32_t evaluation = 0;
  std::uint32_t attempt = 0;
  std::optional<std::string_view> voided;
  bool measured = false;
  std::uint64_t steps = 0;
  std::string_view commanded;
  std::string_view reported;
  std::string_view feet;
};

/// The column recording.checksum, from the rows as they are stored.
class RecordingChecksum {
 public:
  /// In order of evaluation and attempt.
  void add(const TryRow& row);

  experiment::Digest of(const RecordingRow& row) const;

 private:
  std::string tries_;  ///< a digest per line
};

}  // namespace lamprey::storage
