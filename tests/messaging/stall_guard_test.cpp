#include "messaging/program/stall_guard.hpp"

#include <atomic>
#include <csignal>
#include <gtest/gtest.h>
#include <thread>

namespace lamprey::messaging::program {
namespace {

using std::chrono::milliseconds;

TEST(StallGuardTest, EndsAProgramThatStandsStill) {
  std::atomic<int> ended = 0;
  StallGuard guard(milliseconds(100), [&] {
    ++ended;
    ended.notify_all();
  });
  ended.wait(0);
  EXPECT_GE(ended, 1);
}

TEST(StallGuardTest, LeavesALoopThatGoesRoundAlone) {
  std::atomic<int> ended = 0;
  StallGuard guard(milliseconds(1000), [&] { ++ended; });
  for (int turn = 0; turn < 300; ++turn) {
    guard.alive();
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_EQ(ended, 0);
}

TEST(StallGuardTest, IsGoneAtOnce) {
  StallGuard guard(std::chrono::hours(1), [] {});
}

TEST(StallGuardDeathTest, SaysWhyAndAborts) {
  EXPECT_EXIT(
      {
        // The default's limit is a minute; what it does then is the same.
        StallGuard guard(milliseconds(50));
        std::this_thread::sleep_for(std::chrono::seconds(30));
      },
      testing::KilledBySignal(SIGABRT), "");
}

}  // namespace
}  // namespace lamprey::messaging::program
