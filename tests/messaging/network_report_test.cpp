#include "messaging/program/network_report.hpp"

#include "messaging/in_memory/bus.hpp"
#include "messaging/qos.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <sstream>

namespace lamprey::messaging::program {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

/// What is logged meanwhile.
class LogTo {
 public:
  explicit LogTo(std::ostringstream& text) : before_(spdlog::default_logger()) {
    spdlog::set_default_logger(
        std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(text)));
  }
  ~LogTo() { spdlog::set_default_logger(before_); }
  LogTo(const LogTo&) = delete;
  LogTo& operator=(const LogTo&) = delete;

 private:
  std::shared_ptr<spdlog::logger> before_;
};

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

class NetworkReportTest : public ::testing::Test {
 protected:
  in_memory::Bus bus;
  JoinOptions own;
  const NetworkReport::Clock::time_point start = NetworkReport::Clock::now();
};

TEST_F(NetworkReportTest, TellsItsTrafficOnceASecond) {
  const auto participant = bus.join();
  const auto listener = bus.join();
  auto reader = listener->reader<Traffic>(nullptr);
  NetworkReport report(*participant, own);
  for (int turn = 0; turn <= 40; ++turn) report.step(start + milliseconds(50) * turn);
  const auto told = reader->take();
  ASSERT_EQ(told.size(), 3U);
  ASSERT_EQ(told.back().topics.size(), 1U);
  EXPECT_EQ(told.back().topics.front().topic, Topic<Traffic>::name);
  EXPECT_EQ(told.back().topics.front().written, 2U) << "those before";
  EXPECT_EQ(told.back().participant, participant->traffic().participant);
}

TEST_F(NetworkReportTest, WarnsOnceOfEachProgramThatItNeverMeets) {
  const auto participant = bus.join();
  const auto newer = bus.join("worker", discovery::Introduction{.role = "worker",
                                                                .host = "beta",
                                                                .process = 4711,
                                                                .build = "9.0",
                                                                .isolation = own.isolation,
                                                                .wire = wire_version + 1});
  std::ostringstream text;
  {
    const LogTo log(text);
    NetworkReport report(*participant, own);
    for (int turn = 0; turn <= 4; ++turn) report.step(start + std::chrono::seconds(5) * turn);
  }
  EXPECT_THAT(text.str(), HasSubstr("warning"));
  EXPECT_EQ(count(text.str(), "worker beta/4711 (9.0)"), 1U) << text.str();
}

TEST_F(NetworkReportTest, StopsTellingWhenTooManyNamesCome) {
  const auto participant = bus.join();
  std::vector<std::unique_ptr<Participant>> strangers;
  for (std::uint32_t process = 0; process < NetworkReport::most_warnings + 10; ++process) {
    strangers.push_back(bus.join("worker", discovery::Introduction{.role = "worker",
                                                                   .host = "beta",
                                                                   .process = process,
                                                                   .build = "9.0",
                                                                   .isolation = own.isolation,
                                                                   .wire = wire_version + 1}));
  }
  std::ostringstream text;
  {
    const LogTo log(text);
    NetworkReport report(*participant, own);
    report.step(start);
  }
  EXPECT_EQ(count(text.str(), "worker beta/"), NetworkReport::most_warnings);
}

}  // namespace
}  // namespace lamprey::messaging::program
