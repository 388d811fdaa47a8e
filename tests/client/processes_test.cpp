#include "client/failure.hpp"
#include "client/processes/child_process.hpp"
#include "client/processes/fleet.hpp"
#include "client/processes/restart_policy.hpp"
#include "tests/client/site.hpp"

#include <cerrno>
#include <csignal>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace lamprey::client::processes {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

bool eventually(const std::function<bool()>& condition) {
  for (int i = 0; i < 2000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(milliseconds{5});
  }
  return false;
}

TEST(ChildProcess, HandsOverItsLinesAndItsExitCode) {
  ChildProcess child("/bin/sh", {"-c", "echo one; echo two >&2; printf three; exit 7"});
  ASSERT_TRUE(eventually([&] { return child.poll().has_value(); }));
  EXPECT_EQ(child.poll()->code, 7);
  EXPECT_EQ(child.poll()->signal, 0);
  EXPECT_EQ(child.take_lines(), (std::vector<std::string>{"one", "two", "three"}));
  EXPECT_EQ(child.poll()->text(), "ended with exit code 7");
}

TEST(ChildProcess, ASignalIsNotAnExitCode) {
  ChildProcess child("/bin/sh", {"-c", "kill -KILL $$"});
  ASSERT_TRUE(eventually([&] { return child.poll().has_value(); }));
  EXPECT_EQ(child.poll()->signal, SIGKILL);
  EXPECT_EQ(child.poll()->text(), "was killed by signal 9 (Killed)");
}

TEST(ChildProcess, AProgramThatCannotBeStartedIsAnError) {
  EXPECT_THROW(ChildProcess("/nonexistent/program", {}), std::system_error);
}

TEST(ChildProcess, HasAProcessGroupOfItsOwnAndNoneOfOurFiles) {
  ChildProcess child("/bin/sh", {"-c", "ls /proc/self/fd | wc -l; read line && echo input; exec sleep 60"});
  EXPECT_EQ(::getpgid(child.process()), child.process());
  std::vector<std::string> lines;
  ASSERT_TRUE(eventually([&] { return !(lines = child.take_lines()).empty(); }));
  EXPECT_EQ(std::stoi(lines[0]), 4) << "0, 1, 2 and the directory that ls reads";
}

TEST(ChildProcess, DiesWithItsObject) {
  pid_t process = 0;
  {
    ChildProcess child("/bin/sh", {"-c", "trap '' TERM; while true; do sleep 1; done"});
    process = child.process();
    child.send(SIGTERM);
  }
  EXPECT_EQ(::kill(process, 0), -1);
  EXPECT_EQ(errno, ESRCH);
}

TEST(ChildProcess, DiesWithAParentThatIsKilled) {
  int ends[2] = {};
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t parent = ::fork();
  if (parent == 0) {
    ChildProcess child("/bin/sleep", {"60"});
    const pid_t process = child.process();
    [[maybe_unused]] const auto written = ::write(ends[1], &process, sizeof process);
    ::pause();
    ::_exit(0);
  }
  pid_t child = 0;
  ASSERT_EQ(::read(ends[0], &child, sizeof child), static_cast<ssize_t>(sizeof child));
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  // Gone, or dead and not yet collected by whoever inherited it.
  EXPECT_TRUE(eventually([&] {
    std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
    std::string text;
    return !std::getline(stat, text) || text.find(") Z ") != std::string::npos;
  }));
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(RestartPolicy, WaitsLongerEachTimeAndThenGivesUp) {
  RestartPolicy policy;
  EXPECT_EQ(policy.after_death(seconds{1}), milliseconds{250});
  EXPECT_EQ(policy.after_death(seconds{1}), milliseconds{500});
  EXPECT_EQ(policy.after_death(seconds{1}), seconds{1});
  EXPECT_EQ(policy.after_death(seconds{1}), seconds{2});
  for (int death = 5; death <= 12; ++death) EXPECT_EQ(policy.after_death(seconds{1}), seconds{4});
  EXPECT_EQ(policy.after_death(seconds{1}), std::nullopt);
}

TEST(RestartPolicy, ALongLifeEndsTheRow) {
  RestartPolicy policy;
  for (int i = 0; i < 5; ++i) policy.after_death(seconds{1});
  EXPECT_EQ(policy.after_death(seconds{30}), milliseconds{250});
}

/// Shell scripts in the place of the programs: what is tested is who is started, watched and ended.
class FleetTest : public testing::Test {
 protected:
  tests::Site site;
  std::vector<std::string> said;

  void program(const std::string& name, const std::string& script) const {
    ::chmod(site.file(name, "#!/bin/sh\n" + script + "\n").c_str(), 0755);
  }

  std::unique_ptr<Fleet> start(std::uint32_t workers, std::vector<std::string> vendors = {},
                               const std::string& configuration_file = {}) {
    FleetOptions options;
    options.program_folder = site.path("");
    options.database = "x.db";
    options.workers = workers;
    options.join.isolation = "run-test";
    options.join.configuration_file = configuration_file;
    options.worker_vendors = std::move(vendors);
    return std::make_unique<Fleet>(std::move(options), [this](const std::string& line) { said.push_back(line); });
  }

  bool was_said(Fleet& fleet, const std::string& text) {
    return eventually([&] {
      fleet.step(Clock::now());
      return std::ranges::any_of(said, [&](const auto& line) { return line.find(text) != std::string::npos; });
    });
  }

  static constexpr const char* waits = "trap 'exit 0' TERM; while true; do sleep 0.05; done";
};

TEST_F(FleetTest, PassesOptionsOnAndTakesVendorsInTurn) {
  program("lamprey-coordinator", std::string("echo C: $*; ") + waits);
  program("lamprey-worker", std::string("echo W: $*; ") + waits);
  const auto fleet = start(2, {"fastdds", "cyclonedds"});
  EXPECT_TRUE(was_said(*fleet,
                       "C: --dds cyclonedds --domain 0 --isolation run-test --log-level warn --loopback-only "
                       "--database x.db"));
  EXPECT_TRUE(was_said(*fleet, "W: --dds fastdds --domain 0 --isolation run-test"));
  EXPECT_TRUE(was_said(*fleet, "W: --dds cyclonedds --domain 0 --isolation run-test"));
}

// By its peers and interfaces they find a robot's bridge.
TEST_F(FleetTest, PassesTheConfigurationFileOn) {
  program("lamprey-coordinator", std::string("echo C: $*; ") + waits);
  program("lamprey-worker", std::string("echo W: $*; ") + waits);
  const auto fleet = start(1, {}, "/etc/lamprey/lamprey.yaml");
  EXPECT_TRUE(was_said(*fleet, "--loopback-only --config /etc/lamprey/lamprey.yaml --database x.db"));
  EXPECT_TRUE(was_said(*fleet,
                       "W: --dds cyclonedds --domain 0 --isolation run-test --log-level warn --loopback-only "
                       "--config /etc/lamprey/lamprey.yaml"));
}

TEST_F(FleetTest, TheCoordinatorsErrorAndExitCodeAreTheFailure) {
  program(
      "lamprey-coordinator",
      "echo '2026-01-31T12:00:00.123Z error lamprey-coordinator: x.db: another coordinator is using it' >&2; exit 6");
  program("lamprey-worker", waits);
  const auto fleet = start(1);
  std::optional<Failure> failure;
  eventually([&] {
    try {
      fleet->step(Clock::now());
    } catch (const Failure& caught) {
      failure = caught;
    }
    return failure.has_value();
  });
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->exit_code(), exit_storage);
  EXPECT_EQ(failure->messages(), std::vector<std::string>{"x.db: another coordinator is using it"});
  EXPECT_TRUE(said.empty()) << "it is told once";
}

TEST_F(FleetTest, AWorkerThatDiesIsStartedAgain) {
  program("lamprey-coordinator", waits);
  program("lamprey-worker", "if [ -e " + site.path("second") + " ]; then echo again; " + waits + "; fi; touch " +
                                site.path("second") + "; kill -KILL $$");
  const auto fleet = start(1);
  EXPECT_TRUE(was_said(*fleet, "was killed by signal 9 (Killed); starting it again"));
  EXPECT_TRUE(was_said(*fleet, "again"));
}

TEST_F(FleetTest, StoppingKillsWhoeverDoesNotLeave) {
  program("lamprey-coordinator", waits);
  program("lamprey-worker", "trap '' TERM; echo stubborn $$; while true; do sleep 0.05; done");
  const auto fleet = start(1);
  ASSERT_TRUE(was_said(*fleet, "stubborn"));
  const auto process = static_cast<pid_t>(std::stol(said.front().substr(said.front().rfind(' ') + 1)));
  fleet->stop();
  EXPECT_EQ(::kill(process, 0), -1);
}

TEST_F(FleetTest, AMissingProgramIsNamed) {
  program("lamprey-coordinator", waits);
  try {
    start(1);
    FAIL() << "it was started";
  } catch (const Failure& failure) {
    EXPECT_NE(std::string(failure.what()).find("lamprey-worker is not beside"), std::string::npos) << failure.what();
  }
}

}  // namespace
}  // namespace lamprey::client::processes
