#include "messaging/program/stop.hpp"

#include "messaging/program/build_info.hpp"
#include "messaging/program/exit_codes.hpp"

#include <chrono>
#include <csignal>
#include <cstring>
#include <gtest/gtest.h>
#include <memory>
#include <stdexcept>
#include <string>

namespace lamprey::messaging::program {
namespace {

using std::chrono::seconds;

class Stop : public ::testing::TestWithParam<int> {};

TEST_P(Stop, SignalStopsTheTokenAndWakesTheProgram) {
  const auto wake = std::make_shared<Signal>();
  StopOnSignal stop(wake);
  EXPECT_FALSE(stop.requested());
  std::raise(GetParam());
  EXPECT_TRUE(wake->wait_for(seconds(60)));
  EXPECT_TRUE(stop.requested());
  EXPECT_TRUE(stop.token().stop_requested());
}

INSTANTIATE_TEST_SUITE_P(Signals, Stop, ::testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& parameter) { return std::string("SIG") + sigabbrev_np(parameter.param); });

TEST(StopOnce, ATerminalThatGoesIsIgnoredUnderNohup) {
  const auto previous = std::signal(SIGHUP, SIG_IGN);
  {
    StopOnSignal stop(nullptr);
    struct sigaction now {};
    sigaction(SIGHUP, nullptr, &now);
    EXPECT_EQ(now.sa_handler, SIG_IGN);
  }
  EXPECT_EQ(std::signal(SIGHUP, previous), SIG_IGN);
}

TEST(StopOnce, OnlyOneAtATimeButAnyNumberInTurn) {
  {
    StopOnSignal first(nullptr);
    EXPECT_THROW(StopOnSignal second(nullptr), std::logic_error);
  }
  StopOnSignal next(nullptr);
  EXPECT_FALSE(next.requested());
}

TEST(StopDeathTest, SecondInterruptEndsAtOnce) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  EXPECT_EXIT(
      {
        StopOnSignal stop(nullptr);
        std::raise(SIGINT);
        std::raise(SIGINT);
        _exit(exit_ok);
      },
      ::testing::ExitedWithCode(exit_interrupted), "");
}

TEST(StopDeathTest, SecondTerminateAfterAnInterruptDoesNot) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  EXPECT_EXIT(
      {
        StopOnSignal stop(nullptr);
        std::raise(SIGINT);
        std::raise(SIGTERM);
        _exit(exit_ok);
      },
      ::testing::ExitedWithCode(exit_ok), "");
}

TEST(BuildInfo, BeginsWithTheVersionAndNamesTheCommitIfItIsKnown) {
  EXPECT_TRUE(build().starts_with(version()));
  EXPECT_EQ(build().size() > version().size(), !commit().empty());
}

}  // namespace
}  // namespace lamprey::messaging::program
