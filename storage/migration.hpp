#pragma once

#include "storage/connection.hpp"

#include <string>

namespace lamprey::storage {

/// Brings a database of this or an older version to this program's tables, views and parameters: what this program's
/// registry has that its writer's had not, its jobs had at its default, since a registry grows without changing an
/// identity. Identities, outcomes and digests stay as they are. Returns what it did, for people; empty if there was
/// nothing to do. To be called in a write transaction: all of it happens or nothing.
std::string bring_up_to_date(const Connection& connection);

}  // namespace lamprey::storage
