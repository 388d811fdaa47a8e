#pragma once

#include "client/json.hpp"
#include "client/output/console.hpp"
#include "idl/client.pb.h"

#include <cstddef>

namespace lamprey::client::views {

Json worker_json(const idl::WorkerSummary& worker);
Json workers_json(const idl::StatusReply& status);

/// A line each: for a status.
void print_workers(const output::Console& console, const idl::StatusReply& status);

/// Labels, results held, when each was last heard and what it is computing. At most `most` workers, 0: all.
void print_workers_in_detail(const output::Console& console, const idl::StatusReply& status, std::size_t most = 0);

}  // namespace lamprey::client::views
