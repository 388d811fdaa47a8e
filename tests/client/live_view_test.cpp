#include "client/output/bar.hpp"
#include "client/output/formatting.hpp"
#include "client/output/live_screen.hpp"
#include "client/watch_state.hpp"

#include <gtest/gtest.h>
#include <sstream>

namespace lamprey::client {
namespace {

using output::Console;

class LiveViewTest : public testing::Test {
 protected:
  std::ostringstream out;
  std::ostringstream err;
  Console plain{.out = out, .err = err};
  Console terminal{.out = out, .err = err, .out_is_terminal = true, .colour = true, .unicode = true};
};

TEST_F(LiveViewTest, ABarIsFullOnlyWhenNothingIsMissing) {
  EXPECT_EQ(output::bar(plain, {.jobs = 1000, .good = 999}, 10), "#########.");
  EXPECT_EQ(output::bar(plain, {.jobs = 1000, .good = 1000}, 10), "##########");
  EXPECT_EQ(output::bar(plain, {.jobs = 0}, 10), "##########");
}

TEST_F(LiveViewTest, ABarShowsThatSomethingHasHappenedOrFailed) {
  EXPECT_EQ(output::bar(plain, {.jobs = 1'000'000, .good = 1}, 10), "#.........");
  EXPECT_EQ(output::bar(plain, {.jobs = 1'000'000, .good = 500'000, .bad = 1}, 10), "####!.....");
  EXPECT_EQ(output::bar(plain, {.jobs = 10, .bad = 10}, 4), "!!!!");
  EXPECT_EQ(output::bar(plain, {.jobs = 10}, 4), "....");
}

TEST_F(LiveViewTest, StylesTakeNoColumnsAndEndWhereTextIsCut) {
  EXPECT_EQ(output::width("\x1b[1;31mred\x1b[0m"), 3U);
  EXPECT_EQ(output::width(output::bar(terminal, {.jobs = 8, .good = 3, .bad = 2}, 16)), 16U);
  EXPECT_EQ(output::cut("\x1b[1mabcdef\x1b[0m", 4, "…"), "\x1b[1mabc…\x1b[0m");
  EXPECT_EQ(output::cut("\x1b[1mab\x1b[0mcdef", 4, "…"), "\x1b[1mab\x1b[0mc…");
  EXPECT_EQ(output::cut("\x1b[1mabcd\x1b[0m", 4, "…"), "\x1b[1mabcd\x1b[0m");
}

TEST_F(LiveViewTest, TimesAreUniversal) {
  EXPECT_EQ(output::date_and_time(0), "1970-01-01 00:00:00");
  EXPECT_EQ(output::date_and_time(1'769'860'800'999), "2026-01-31 12:00:00");
}

TEST_F(LiveViewTest, AScreenIsRewrittenInPlaceAndNeverTallerThanTheTerminal) {
  output::LiveScreen screen(terminal);
  const output::TerminalSize size{.columns = 10, .rows = 3};
  screen.draw({"a", "0123456789"}, size);
  EXPECT_EQ(out.str(), "\ra\x1b[K\n01234567…\x1b[K\n\x1b[J");
  out.str("");
  screen.draw({"b", "c", "d", "e"}, size);
  EXPECT_EQ(out.str(), "\x1b[2A\rb\x1b[K\nc\x1b[K\n\x1b[J");
  out.str("");
  screen.draw({"f"}, size);
  EXPECT_EQ(out.str(), "\x1b[2A\rf\x1b[K\n\x1b[J");
}

idl::StatusReply status_of(int sweeps) {
  idl::StatusReply status;
  status.set_database("c.db");
  for (int i = 0; i < sweeps; ++i) {
    auto& sweep = *status.add_sweeps();
    sweep.set_name("sweep-" + std::to_string(i));
    sweep.set_id(experiment::to_hex(experiment::Id128{5, static_cast<std::uint64_t>(i)}));
    sweep.set_state(i + 1 < sweeps ? "finished" : "running");
    sweep.mutable_counts()->set_jobs(10);
    sweep.mutable_counts()->set_pending(10);
  }
  return status;
}

idl::EventsReply events(std::uint64_t first, std::uint64_t count) {
  idl::EventsReply reply;
  for (std::uint64_t i = first; i < first + count; ++i) {
    auto& event = *reply.add_events();
    event.set_event(i);
    event.set_kind("lease_lost");
    event.set_text("number " + std::to_string(i));
  }
  return reply;
}

TEST_F(LiveViewTest, PublishedProgressMakesTheStatusFresher) {
  WatchState state;
  state.take(status_of(1));
  messaging::SweepProgress progress;
  progress.sweep = {5, 0};
  progress.state = "running";
  progress.jobs = 10;
  progress.done = 5;
  EXPECT_TRUE(state.take(progress));
  EXPECT_NE(state.frame(plain, "", 40).find(" 50 %"), std::string::npos) << state.frame(plain, "", 40);
  progress.sweep = {6, 0};
  EXPECT_FALSE(state.take(progress)) << "nobody has told of that sweep";
}

TEST_F(LiveViewTest, SweepsThatGoOnAreSeenWhereThereIsNoRoomForAll) {
  WatchState state;
  state.take(status_of(30));
  const auto frame = state.frame(plain, "", 20);
  EXPECT_NE(frame.find("sweep-29"), std::string::npos) << frame;
  EXPECT_NE(frame.find("more sweeps"), std::string::npos) << frame;
  EXPECT_LT(std::ranges::count(frame, '\n'), 20);
}

TEST_F(LiveViewTest, ANoteAndEscapesOfADatabasesNameAreHarmless) {
  WatchState state;
  auto status = status_of(1);
  status.set_database("\x1b[2J");
  state.take(status);
  const auto frame = state.frame(plain, "no word", 20);
  EXPECT_NE(frame.find("no word"), std::string::npos);
  EXPECT_EQ(frame.find('\x1b'), std::string::npos);
}

TEST_F(LiveViewTest, OnlyWhatIsNewGetsALine) {
  WatchState state;
  auto status = status_of(1);
  state.take(status);
  state.take(events(1, 3));
  auto lines = state.new_lines(plain, 0);
  ASSERT_EQ(lines.size(), 1U) << "a sweep, and no event that was there before";
  EXPECT_NE(lines[0].find("progress             sweep-0  0 / 10"), std::string::npos) << lines[0];
  status.mutable_sweeps(0)->set_jobs_per_second(5);
  state.take(status);
  state.take(events(3, 1));
  EXPECT_TRUE(state.new_lines(plain, 0).empty()) << "a rate is no change, and event 3 is known";
  status.mutable_sweeps(0)->mutable_counts()->set_done(1);
  status.set_storage_fault("no space left");
  state.take(status);
  state.take(events(4, 20));
  lines = state.new_lines(plain, 0);
  ASSERT_EQ(lines.size(), 22U);
  EXPECT_NE(lines[0].find("number 4"), std::string::npos);
  EXPECT_NE(lines[20].find("storage_fault        no space left"), std::string::npos) << lines[20];
  EXPECT_EQ(state.newest_event(), 23U);
  EXPECT_EQ(state.json()["events"].size(), WatchState::most_events);
}

}  // namespace
}  // namespace lamprey::client
