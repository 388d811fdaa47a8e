#pragma once

#include "client/failure.hpp"
#include "storage/results_store.hpp"

namespace lamprey::client {

/// The failure that a storage error is to the user: its code is the name of its kind.
Failure storage_failure(const storage::StorageError& error);

}  // namespace lamprey::client
