#include "robot_bridge/recording/step_recorder.hpp"

#include "tests/robot_bridge/recording/records.hpp"

#include <csignal>
#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>
#include <sys/resource.h>

namespace lamprey::robot_bridge::recording {
namespace {

constexpr int message = 0x05;

std::vector<Octets> messages_on(std::uint16_t channel, const Octets& file) {
  std::vector<Octets> found;
  for (const auto& record : records(file)) {
    if (record.opcode != message || number<std::uint16_t>(record.content, 0) != channel) continue;
    constexpr std::ptrdiff_t head = 2 + 4 + 8 + 8;
    found.emplace_back(record.content.begin() + head, record.content.end());
  }
  return found;
}

class StepRecorderTest : public testing::Test {
 protected:
  messaging::ServoState state() const {
    messaging::ServoState made;
    made.token = 3;
    made.evaluation = 2;
    made.time_step = 1;
    made.commanded.fill(12);
    made.reported.fill(11);
    made.feet_down = 0b1010;
    return made;
  }
  ScratchFile file;
  std::chrono::system_clock::time_point time{std::chrono::seconds{1000} + std::chrono::nanoseconds{5000}};
};

TEST_F(StepRecorderTest, WritesWhatWasReportedAndWhatWasCommanded) {
  { StepRecorder(file.path(), mock_calibration()).add(state(), time); }
  const auto reported = messages_on(1, file.octets());
  const auto commanded = messages_on(2, file.octets());
  ASSERT_EQ(reported.size(), 1U);
  ASSERT_EQ(commanded.size(), 1U);
  const Octets& cdr = reported.front();
  EXPECT_EQ(number<std::uint32_t>(cdr, 0), 0x00000100U) << "CDR, little-endian";
  EXPECT_EQ(number<std::uint32_t>(cdr, 4), 1000U) << "seconds";
  EXPECT_EQ(number<std::uint32_t>(cdr, 8), 5000U) << "nanoseconds";
  // The last of eight angles stands before two empty lists.
  const double unit = 4.5 * std::numbers::pi / 180;
  EXPECT_NEAR(number<double>(cdr, cdr.size() - 16), 1 * unit, 1e-12);
  EXPECT_NEAR(number<double>(commanded.front(), cdr.size() - 16), 2 * unit, 1e-12);
}

TEST_F(StepRecorderTest, AVoidStepHasItsReasonAndNoAngles) {
  auto voided = state();
  voided.outcome = messaging::StepOutcome::voided;
  voided.reason = "a step is late";
  { StepRecorder(file.path(), mock_calibration()).add(voided, time); }
  EXPECT_TRUE(messages_on(1, file.octets()).empty());
  const auto steps = messages_on(3, file.octets());
  ASSERT_EQ(steps.size(), 1U);
  const std::string text(steps.front().begin(), steps.front().end());
  EXPECT_NE(text.find(voided.reason), std::string::npos);
}

TEST_F(StepRecorderTest, NothingIsLostAtTheEnd) {
  constexpr int steps = 1000;
  {
    StepRecorder recorder(file.path(), mock_calibration());
    for (int step = 0; step < steps; ++step) recorder.add(state(), time + std::chrono::milliseconds(step));
  }
  EXPECT_EQ(messages_on(3, file.octets()).size(), static_cast<std::size_t>(steps));
  EXPECT_EQ(records(file.octets()).back().opcode, 0x02) << "the footer";
}

TEST_F(StepRecorderTest, ADiskThatIsFullCostsTheRecordingAlone) {
  constexpr rlim_t most_octets = 8192;
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit = before;
  limit.rlim_cur = most_octets;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  {
    StepRecorder recorder(file.path(), mock_calibration());
    for (int step = 0; step < 1000; ++step) recorder.add(state(), time);
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(file.octets().size(), most_octets);
  EXPECT_FALSE(messages_on(3, file.octets()).empty()) << "what had room is readable";
}

TEST_F(StepRecorderTest, AFileThatCannotBeWrittenIsAnErrorAtOnce) {
  EXPECT_THROW(StepRecorder("/dev/full", mock_calibration()), std::runtime_error);
}

}  // namespace
}  // namespace lamprey::robot_bridge::recording
