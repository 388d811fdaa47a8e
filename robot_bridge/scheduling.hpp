#pragma once

#include <string>

namespace lamprey::robot_bridge {

/// Asks the system to run the calling thread before all ordinary ones (SCHED_FIFO) and to keep its memory; says what it
/// has granted: "SCHED_FIFO 50", or "SCHED_OTHER (SCHED_FIFO refused: …)".
std::string make_this_thread_timely();

}  // namespace lamprey::robot_bridge
