#pragma once

#include "experiment/outcome.hpp"
#include "idl/sweep.pb.h"
#include "storage/results_store.hpp"

#include <string>

namespace lamprey::coordinator {

/// Whether a sweep is to end early by its `stop_when` and `fail_fast`: why, as "highest_total is 342, at least 340";
/// empty if not. `outcome`: of a job that has just been stored; counts are those after it.
std::string reason_to_stop(const idl::Execution& execution, const experiment::Outcome& outcome);
std::string reason_to_stop(const idl::Execution& execution, const storage::JobCounts& counts,
                           std::uint64_t divergences);

}  // namespace lamprey::coordinator
