#include "storage/store_implementation.hpp"

#include <algorithm>
#include <limits>

namespace lamprey::storage {

std::vector<ResultsStore::StoredEvent> ResultsStore::events(std::optional<std::int64_t> sweep, std::int64_t after,
                                                            std::uint64_t most) const {
  const bool newest = after == 0;
  Statement rows(implementation_->connection,
                 std::string("SELECT event, at, kind, sweep, job, worker, text FROM event WHERE event > ?1") +
                     (sweep ? " AND sweep = ?3" : "") + " ORDER BY event" + (newest ? " DESC" : "") + " LIMIT ?2");
  // SQLite takes a negative limit for none at all.
  rows.with(after, std::min<std::uint64_t>(most, std::numeric_limits<std::int64_t>::max()));
  if (sweep) rows.bind(3, *sweep);
  std::vector<StoredEvent> events;
  while (rows.step()) {
    auto& event = events.emplace_back();
    event.number = rows.integer(0);
    event.unix_milliseconds = rows.integer(1);
    event.event.kind = rows.text(2);
    if (!rows.is_null(3)) event.event.sweep = rows.integer(3);
    if (!rows.is_null(4)) event.event.job = rows.bits(4);
    event.event.worker = rows.bits(5);
    event.event.text = rows.text(6);
  }
  if (newest) std::ranges::reverse(events);
  return events;
}

}  // namespace lamprey::storage
