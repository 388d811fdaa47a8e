#include "messaging/port.hpp"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace lamprey::messaging {
namespace {

using std::chrono::milliseconds;

TEST(Signal, NotificationBeforeTheWaitIsNotLost) {
  Signal signal;
  signal.notify();
  EXPECT_TRUE(signal.wait_for(milliseconds(0)));
}

TEST(Signal, WaitConsumesAllNotificationsSoFar) {
  Signal signal;
  signal.notify();
  signal.notify();
  EXPECT_TRUE(signal.wait_for(milliseconds(0)));
  EXPECT_FALSE(signal.wait_for(milliseconds(0)));
}

TEST(Signal, NotificationFromAnotherThreadEndsTheWait) {
  Signal signal;
  std::jthread other([&] { signal.notify(); });
  EXPECT_TRUE(signal.wait_for(milliseconds(60'000)));
}

}  // namespace
}  // namespace lamprey::messaging
