#include "messaging/qos.hpp"
#include "tests/conformance/world.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <poll.h>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

extern char** environ;

namespace lamprey::messaging::conformance {
namespace {

/// About 20 KB on the wire.
ResultBatch batch(std::uint64_t sequence) {
  ResultBatch sample;
  sample.sequence = sequence;
  sample.results.resize(1);
  sample.results[0].job = sequence;
  sample.results[0].outcome.trace.resize(500);
  return sample;
}

/// The sequence numbers without those of the marker, 0.
std::vector<std::uint64_t> sequences(const std::vector<ResultBatch>& batches) {
  std::vector<std::uint64_t> all;
  for (const auto& sample : batches) {
    if (sample.sequence != 0) all.push_back(sample.sequence);
  }
  return all;
}

std::vector<std::uint64_t> one_to(std::uint64_t last) {
  std::vector<std::uint64_t> all;
  for (std::uint64_t i = 1; i <= last; ++i) all.push_back(i);
  return all;
}

auto until(std::uint64_t last) {
  return [last](const std::vector<ResultBatch>& all) { return !all.empty() && all.back().sequence == last; };
}

class Flow : public World {};

TEST_P(Flow, TwoThousandBatchesWrittenAndTakenByTwoThreadsArriveCompleteAndInOrder) {
  constexpr std::uint64_t count = 2000;
  auto from = join_writer();
  auto to = join_reader();
  auto writer = from->writer<ResultBatch>();
  Inbox<ResultBatch> inbox(*to);
  meet(*writer, inbox, batch(0));
  std::jthread thread([&] {
    for (std::uint64_t i = 1; i <= count; ++i) write(*writer, batch(i));
  });
  EXPECT_TRUE(inbox.take_until(until(count)));
  EXPECT_EQ(sequences(inbox.samples), one_to(count));
}

/// Writes batches 1, 2, … until the writer is full, at most so many; the last that was written.
std::uint64_t write_while_nobody_takes(Writer<ResultBatch>& writer, std::uint64_t most) {
  for (std::uint64_t i = 1; i <= most; ++i) {
    const WriteResult result = writer.write(batch(i));
    if (result) continue;
    EXPECT_EQ(result.kind, WriteResult::Kind::full) << result.error;
    return i - 1;
  }
  return most;
}

TEST_P(Flow, ReaderThatTakesLateLosesNothing) {
  auto from = join_writer();
  auto to = join_reader();
  auto writer = from->writer<ResultBatch>();
  Inbox<ResultBatch> inbox(*to);
  meet(*writer, inbox, batch(0));
  const std::uint64_t written = write_while_nobody_takes(*writer, 1500);
  EXPECT_GE(written, 8u) << "so little in flight cannot be fast";
  const std::uint64_t count = written + 200;
  std::jthread thread([&] {
    for (std::uint64_t i = written + 1; i <= count; ++i) write(*writer, batch(i));
  });
  EXPECT_TRUE(inbox.take_until(until(count)));
  EXPECT_EQ(sequences(inbox.samples), one_to(count));
}

TEST_P(Flow, ReaderThatNeverTakesHoldsABoundedNumber) {
  auto from = join_writer();
  auto to = join_reader();
  auto writer = from->writer<Request>();
  Inbox<Request> inbox(*to);
  Request request;
  write(*writer, request);
  ASSERT_TRUE(inbox.take_until_size(1));
  inbox.samples.clear();
  constexpr std::uint64_t written = 6000;
  for (request.correlation = 1; request.correlation <= written; ++request.correlation) {
    static_cast<void>(writer->write(request));
  }
  inbox.take();
  EXPECT_LE(inbox.samples.size(), 4096u);
}

TEST_P(Flow, UntakenResultsDoNotHoldUpOtherTopics) {
  auto from = join_writer();
  auto to = join_reader();
  auto results = from->writer<ResultBatch>();
  auto requests = from->writer<Request>();
  Inbox<ResultBatch> result_inbox(*to);
  Inbox<Request> request_inbox(*to);
  meet(*results, result_inbox, batch(0));
  write_while_nobody_takes(*results, 1500);
  Request request;
  request.correlation = 17;
  write(*requests, request);
  EXPECT_TRUE(request_inbox.take_until_size(1));
}

TEST_P(Flow, ReaderThatIsDestroyedFullLetsTheWriterGoOn) {
  auto from = join_writer();
  auto to = join_reader();
  auto writer = from->writer<ResultBatch>();
  auto inbox = std::make_unique<Inbox<ResultBatch>>(*to);
  meet(*writer, *inbox, batch(0));
  write_while_nobody_takes(*writer, 1500);
  inbox.reset();
  write(*writer, batch(2));
}

INSTANTIATE_TEST_SUITE_P(Port, Flow, ::testing::ValuesIn(all_pairs()), pair_name);

/// A process that reads one batch and then never again.
class SilentReader {
 public:
  explicit SilentReader(const JoinOptions& options) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe2");
    output_ = ends[0];
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    std::string program = LAMPREY_SILENT_READER;
    std::string vendor = options.vendor;
    std::string domain = std::to_string(options.domain);
    std::string isolation = options.isolation;
    std::array<char*, 5> arguments{program.data(), vendor.data(), domain.data(), isolation.data(), nullptr};
    const int error = posix_spawn(&process_, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (error != 0) throw std::runtime_error("cannot start " + program);
  }
  ~SilentReader() {
    kill();
    close(output_);
  }
  SilentReader(const SilentReader&) = delete;
  SilentReader& operator=(const SilentReader&) = delete;

  bool is_ready() const {
    pollfd poll_for{output_, POLLIN, 0};
    return poll(&poll_for, 1, 0) == 1;
  }

  void kill() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    process_ = -1;
  }

 private:
  pid_t process_ = -1;
  int output_ = -1;
};

class DeadReader : public World {};

TEST_P(DeadReader, HoldsNoWriteUpForLongAndIsForgottenInTheEnd) {
  auto from = join_writer();
  auto writer = from->writer<ResultBatch>();
  SilentReader reader(options(GetParam().reader, ""));
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (!reader.is_ready()) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline);
    write(*writer, batch(0));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  reader.kill();

  // The reader's history no longer takes anything, so at most the writer's own fills up.
  bool was_full = false;
  for (std::uint64_t i = 1; i < 2 * Topic<ResultBatch>::profile.depth && !was_full; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const WriteResult result = writer->write(batch(i));
    EXPECT_NE(result.kind, WriteResult::Kind::failed) << result.error;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << "blocked, not 100 ms late";
    was_full = !result;
  }
  EXPECT_TRUE(was_full) << "the dead reader was forgotten before the writer's history was full";
  write(*writer, batch(1));
}

INSTANTIATE_TEST_SUITE_P(Port, DeadReader, ::testing::ValuesIn(network_pairs()), pair_name);

}  // namespace
}  // namespace lamprey::messaging::conformance
