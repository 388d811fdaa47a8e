#pragma once

#include "storage/connection.hpp"

#include <string>

namespace lamprey::storage {

/// Brings a database of this or an older version to this program's tables, views and parameters: what this program's
/// registry has that its writer's had not, its jobs had at its default, since a registry grows without changing an
/// identity. Identities, outcomes and digests stay as they are. Returns what it did, for people; empty if there was
/// nothing to do. To be called in a write transaction, with the settings of TablesMayBeRebuilt: all of it happens or
/// nothing.
std::string bring_up_to_date(const Connection& connection);

/// While it lives, other tables may go on referring to a table that is made anew and takes the old one's name, as
/// https://www.sqlite.org/lang_altertable.html (section 7) has it: without enforcement of foreign keys, and without
/// rewriting of the views that people have added. To be made outside of a transaction, for one that migrates.
class TablesMayBeRebuilt {
 public:
  explicit TablesMayBeRebuilt(const Connection& connection);
  ~TablesMayBeRebuilt();
  TablesMayBeRebuilt(const TablesMayBeRebuilt&) = delete;
  TablesMayBeRebuilt& operator=(const TablesMayBeRebuilt&) = delete;

 private:
  const Connection& connection_;
};

}  // namespace lamprey::storage
