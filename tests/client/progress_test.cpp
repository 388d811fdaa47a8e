#include "client/output/progress.hpp"

#include <gtest/gtest.h>
#include <sstream>

namespace lamprey::client::output {
namespace {

using std::chrono::seconds;

messaging::SweepProgress running() {
  messaging::SweepProgress progress;
  progress.name = "mutate-all";
  progress.state = "running";
  progress.jobs = 18432;
  progress.done = 12340;
  progress.failed = 5;
  progress.leased = 350;
  progress.pending = 5737;
  progress.jobs_per_second = 612;
  progress.seconds_left = 10;
  progress.workers = 2;
  return progress;
}

TEST(ProgressLine, HasCountsRateAndTimeLeft) {
  EXPECT_EQ(progress_line(running()),
            "mutate-all  12,345 / 18,432  66 %  done 12,340  failed 5  leased 350  612 jobs/s  10 s left");
}

TEST(ProgressLine, SaysAHundredPercentOnlyAtTheEnd) {
  auto progress = running();
  progress.failed = 0;
  progress.done = 18431;
  EXPECT_NE(progress_line(progress).find("  99 %"), std::string::npos);
  progress.done = 18432;
  EXPECT_EQ(progress_line(progress), "mutate-all  18,432 / 18,432  100 %  done 18,432  failed 0");
}

TEST(ProgressLine, NamesRareStatesOnlyWhereTheyOccur) {
  auto progress = running();
  progress.quarantined = 2;
  progress.divergences = 1;
  EXPECT_NE(progress_line(progress).find("  quarantined 2  divergent 1  "), std::string::npos);
}

TEST(ProgressLine, SaysWhatItWaitsFor) {
  auto progress = running();
  progress.workers = 0;
  EXPECT_TRUE(progress_line(progress).ends_with("leased 350  waiting for workers"));
  progress.state = "cancelling";
  EXPECT_TRUE(progress_line(progress).ends_with("  cancelling"));
}

class DisplayTest : public testing::Test {
 protected:
  std::ostringstream out;
  std::ostringstream err;
  ProgressDisplay::Clock::time_point start{std::chrono::hours{1}};
};

TEST_F(DisplayTest, WithoutATerminalLinesComeEveryFiveSeconds) {
  const Console console{.out = out, .err = err};
  ProgressDisplay display(console, false);
  display.show("a", start);
  display.show("b", start + seconds{1});
  display.show("c", start + seconds{5});
  display.show("c", start + seconds{20});
  display.show("d", start + seconds{21}, true);
  EXPECT_EQ(err.str(), "a\nc\nd\n");
}

TEST_F(DisplayTest, OnATerminalOneLineIsRewrittenAndMessagesStayAboveIt) {
  const Console console{.out = out, .err = err, .err_is_terminal = true, .columns = 80};
  {
    ProgressDisplay display(console, false);
    display.show("a", start);
    display.say("note");
  }
  EXPECT_EQ(err.str(), "\ra\x1b[K\r\x1b[Knote\n\ra\x1b[K\r\x1b[K");
}

TEST_F(DisplayTest, ALineNeverFillsTheTerminal) {
  const Console console{.out = out, .err = err, .err_is_terminal = true, .columns = 8};
  ProgressDisplay display(console, false);
  display.show("0123456789", start);
  EXPECT_EQ(err.str(), "\r0123...\x1b[K");
}

TEST_F(DisplayTest, QuietHidesProgressButNotMessages) {
  const Console console{.out = out, .err = err};
  ProgressDisplay display(console, true);
  display.show("a", start);
  display.say("note");
  EXPECT_EQ(err.str(), "note\n");
}

}  // namespace
}  // namespace lamprey::client::output
