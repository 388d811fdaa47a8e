#include "messaging/program/run.hpp"

#include "messaging/port.hpp"
#include "messaging/program/exit_codes.hpp"

#include <array>
#include <functional>
#include <gtest/gtest.h>
#include <spdlog/spdlog.h>
#include <stdexcept>
#include <string>

namespace lamprey::messaging::program {
namespace {

class Run : public ::testing::Test {
 protected:
  /// Of a program without options of its own.
  static int run_with(std::string argument, const std::function<int()>& serve) {
    CLI::App app;
    app.name("lamprey-test");
    const auto logger = spdlog::default_logger();
    std::string name = "lamprey-test";
    std::array<char*, 2> arguments{name.data(), argument.data()};
    const int code = run(app, argument.empty() ? 1 : 2, arguments.data(), {}, serve);
    spdlog::set_default_logger(logger);
    return code;
  }
};

TEST_F(Run, EndsWithWhatServingReturns) {
  EXPECT_EQ(run_with("", [] { return 42; }), 42);
}

TEST_F(Run, DoesNotServeAfterABadOrAnAnsweredCommandLine) {
  bool served = false;
  const auto serve = [&] {
    served = true;
    return 42;
  };
  EXPECT_EQ(run_with("--unknown", serve), exit_usage);
  EXPECT_EQ(run_with("--help", serve), exit_ok);
  EXPECT_FALSE(served);
}

TEST_F(Run, TurnsWhatIsThrownIntoExitCodes) {
  EXPECT_EQ(run_with("", []() -> int { throw CLI::ValidationError("--port: it needs one"); }), exit_usage);
  EXPECT_EQ(run_with("", []() -> int { throw JoinError("no network"); }), exit_unreachable);
  EXPECT_EQ(run_with("", []() -> int { throw std::runtime_error("something else"); }), exit_failure);
}

}  // namespace
}  // namespace lamprey::messaging::program
