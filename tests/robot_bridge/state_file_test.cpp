#include "robot_bridge/state_file.hpp"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace lamprey::robot_bridge {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class StateFileTest : public ::testing::Test {
 protected:
  StateFileTest() { std::filesystem::remove_all(folder_); }
  ~StateFileTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("lamprey-state-file-test-" + std::to_string(::getpid()));
};

TEST_F(StateFileTest, BeginsWithNothingClaimedAndNothingStopped) {
  EXPECT_EQ(StateFile(folder_ / "deeper", "bench").state(), StoredState{});
}

TEST_F(StateFileTest, KeepsWhatWasStored) {
  const StoredState state{.newest_token = 18'000'000'000'000'000'000U, .stopped = true, .stop_reason = "it \"smells\""};
  StateFile(folder_, "bench").store(state);
  EXPECT_EQ(StateFile(folder_, "bench").state(), state);
  EXPECT_EQ(StateFile(folder_, "other").state(), StoredState{});
}

TEST_F(StateFileTest, AStopThatCannotBeStoredIsInForceAllTheSame) {
  StateFile file(folder_, "bench");
  std::filesystem::remove_all(folder_);
  EXPECT_ANY_THROW(file.latch("smoke"));
  EXPECT_TRUE(file.state().stopped);
  EXPECT_EQ(file.state().stop_reason, "smoke");
}

TEST_F(StateFileTest, ARobotHasOneBridge) {
  auto file = std::make_unique<StateFile>(folder_, "bench");
  EXPECT_THAT([&] { StateFile(folder_, "bench"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("robot 'bench' has a bridge already")));
  file.reset();
  EXPECT_NO_THROW(StateFile(folder_, "bench"));
}

TEST_F(StateFileTest, AFileThatNoBridgeHasWrittenIsRefusedAndKept) {
  for (const std::string text : {"", "{}", "[1,2", R"({"format":"lamprey-robot-state/9","newest_token":1})",
                                 R"({"format":"lamprey-robot-state/1","newest_token":-1,"stopped":0})"}) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "bench.json") << text;
    EXPECT_THAT([&] { StateFile(folder_, "bench"); },
                ThrowsMessage<std::runtime_error>(HasSubstr("is no robot's state")))
        << text;
    std::ifstream kept(folder_ / "bench.json");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(kept), {}), text);
  }
}

}  // namespace
}  // namespace lamprey::robot_bridge
