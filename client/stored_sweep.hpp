#pragma once

#include "client/sweep_input.hpp"
#include "messaging/samples.hpp"

#include <optional>
#include <string>

namespace lamprey::client {

/// The sweep as a database file has it, read without changing anything; nothing if there is no such file, no such sweep
/// in it, or it is of another science version. Throws storage::StorageError, and Failure (sweep_changed) if another
/// sweep has its name.
std::optional<messaging::SweepProgress> stored_sweep(const std::string& database, const SweepInput& sweep);

}  // namespace lamprey::client
