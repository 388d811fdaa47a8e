#pragma once

#include "client/json.hpp"
#include "client/output/console.hpp"
#include "idl/client.pb.h"

#include <string>

namespace lamprey::client::views {

/// {"event", "at" (milliseconds since 1970), "kind", "sweep" or null, "job" or null, "worker" or null, "text"}
Json event_json(const idl::EventsReply::Event& event);

/// "2026-01-31 12:00:00  job_quarantined      mutate-all  job 12  worker 10cfda95e77a9275  lost three times": the time
/// is universal.
std::string event_line(const output::Console& console, const idl::EventsReply::Event& event);

/// A line of that form for something that is no event of the database.
std::string event_line(const output::Console& console, std::int64_t unix_milliseconds, const std::string& kind,
                       const std::string& text);

}  // namespace lamprey::client::views
