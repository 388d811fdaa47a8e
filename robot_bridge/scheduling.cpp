#include "robot_bridge/scheduling.hpp"

#include <cstring>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>

namespace lamprey::robot_bridge {

std::string make_this_thread_timely() {
  // By default the system may wake an ordinary thread 50 µs late, to save power.
  ::prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
  constexpr int priority = 50;
  const sched_param wanted{.sched_priority = priority};
  const int refused = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &wanted);
  if (refused != 0) return "SCHED_OTHER (SCHED_FIFO refused: " + std::string(std::strerror(refused)) + ")";
  // A page that has to be fetched from the disk is worse than any scheduling.
  const bool locked = ::mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
  return "SCHED_FIFO " + std::to_string(priority) + (locked ? "" : ", memory not locked");
}

}  // namespace lamprey::robot_bridge
