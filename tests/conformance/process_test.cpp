#include "messaging/qos.hpp"
#include "tests/conformance/numbered.hpp"
#include "tests/conformance/other_program.hpp"
#include "tests/conformance/world.hpp"

#include <algorithm>
#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <thread>
#include <vector>

/// Readers and writers that are stopped, killed and started again.
namespace lamprey::messaging::conformance {
namespace {

using Numbers = std::vector<std::uint64_t>;

constexpr std::uint64_t lease_depth = Topic<Lease>::profile.depth;

/// About 20 KB on the wire.
ResultBatch batch(std::uint64_t number) {
  auto sample = numbered<ResultBatch>(number);
  sample.results.resize(1);
  sample.results[0].outcome.trace.resize(500);
  return sample;
}

auto until(std::uint64_t last) {
  return [last](const Numbers& said) { return !said.empty() && said.back() == last; };
}
template <class Sample>
bool take_until(Inbox<Sample>& inbox, std::uint64_t last) {
  return inbox.take_until([last](const auto& all) { return !all.empty() && number_of(all.back()) == last; });
}

/// From the first on, with none missing, out of order or twice.
void expect_unbroken(const Numbers& numbers) {
  ASSERT_FALSE(numbers.empty());
  EXPECT_EQ(numbers, numbers_from(numbers.front(), numbers.back()));
}

class OtherReader : public World {
 protected:
  OtherProgram start(const std::string& topic, std::uint64_t receiver, const std::string& action) {
    return {options(GetParam().reader, ""), {topic, std::to_string(receiver), action}};
  }
};

/// Writes results until the reader has said something.
void write_until_heard(Writer<ResultBatch>& writer, OtherProgram& reader, std::uint64_t& number) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  const auto heard = [&](const Numbers& said) {
    if (!said.empty()) return true;
    write(writer, batch(++number));
    return std::chrono::steady_clock::now() > deadline;
  };
  ASSERT_TRUE(reader.listen_until(heard));
  ASSERT_FALSE(reader.said.empty()) << "writer and reader did not meet";
}

TEST_P(OtherReader, ThatDiesHoldsNoWriteUpForLongAndIsForgottenInTheEnd) {
  auto from = join_writer();
  auto writer = from->writer<ResultBatch>();
  auto reader = start("result", 0, "read-once");
  std::uint64_t number = 0;
  write_until_heard(*writer, reader, number);
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

constexpr std::chrono::seconds pause_of_a_stopped_reader{3};

TEST_P(OtherReader, ThatIsStoppedLeavesOthersTheirLeasesAndGetsTheLastOnesAfterwards) {
  auto from = join_writer();
  auto to = join_reader();
  auto writer = from->writer<Lease>();
  Inbox<Lease> inbox(*to);
  auto reader = start("lease", 0, "read");
  write(*writer, numbered<Lease>(1));
  ASSERT_TRUE(reader.listen_until(until(1)));

  reader.stop();
  const auto begin = std::chrono::steady_clock::now();
  // More than the socket of the reader that is stopped can hold.
  constexpr std::uint64_t last = 12'000;
  for (std::uint64_t i = 2; i <= last; ++i) {
    const WriteResult result = writer->write(numbered<Lease>(i));
    ASSERT_TRUE(result) << "held up by a stopped reader, though the profile is keep-last: " << result.error;
    if (i % 100 != 0) continue;
    ASSERT_TRUE(take_until(inbox, i)) << "the reader that is not stopped does not get lease " << i;
  }
  EXPECT_EQ(numbers_of(inbox.samples), numbers_from(1, last));
  std::this_thread::sleep_until(begin + pause_of_a_stopped_reader);

  reader.resume();
  ASSERT_TRUE(reader.listen_until(until(last)));
  const auto& said = reader.said;
  EXPECT_EQ(std::adjacent_find(said.begin(), said.end(), std::greater_equal<>()), said.end()) << "twice or too late";
  ASSERT_GE(said.size(), lease_depth);
  EXPECT_EQ(Numbers(said.end() - static_cast<std::ptrdiff_t>(lease_depth), said.end()),
            numbers_from(last + 1 - lease_depth, last));
}

TEST_P(OtherReader, ThatIsStoppedLeavesOthersTheirResultsAndGetsAllAfterwards) {
  auto from = join_writer();
  auto to = join_reader();
  auto writer = from->writer<ResultBatch>();
  Inbox<ResultBatch> inbox(*to);
  auto reader = start("result", 0, "read");
  std::uint64_t number = 0;
  meet(*writer, inbox, batch(0));
  write_until_heard(*writer, reader, number);

  reader.stop();
  const auto end = std::chrono::steady_clock::now() + pause_of_a_stopped_reader;
  while (std::chrono::steady_clock::now() < end) {
    const WriteResult result = writer->write(batch(number + 1));
    ASSERT_NE(result.kind, WriteResult::Kind::failed) << result.error;
    if (!result) continue;
    ++number;
    ASSERT_TRUE(take_until(inbox, number)) << "the reader that is not stopped does not get batch " << number;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  reader.resume();
  for (const auto last = number + 100; number < last;) write(*writer, batch(++number));
  ASSERT_TRUE(reader.listen_until(until(number)));
  std::erase(reader.said, 0);
  expect_unbroken(reader.said);
  ASSERT_TRUE(take_until(inbox, number));
  auto received = numbers_of(inbox.samples);
  std::erase(received, 0);
  EXPECT_EQ(received, numbers_from(1, number));
}

TEST_P(OtherReader, ThatDiesIsSucceededByOneThatGetsTheHistoryAndWhatFollows) {
  auto from = join_writer();
  auto writer = from->writer<Lease>(Partition::of(7));
  auto first = start("lease", 7, "read");
  for (std::uint64_t i = 1; i <= 100; ++i) write(*writer, numbered<Lease>(i));
  ASSERT_TRUE(first.listen_until(until(100)));
  EXPECT_EQ(first.said, numbers_from(1, 100));
  first.kill();

  constexpr std::uint64_t written = 100 + lease_depth + 30;
  for (std::uint64_t i = 101; i <= written; ++i) write(*writer, numbered<Lease>(i));
  auto second = start("lease", 7, "read");
  ASSERT_TRUE(second.listen_until(until(written)));
  for (std::uint64_t i = 1; i <= 100; ++i) write(*writer, numbered<Lease>(written + i));
  ASSERT_TRUE(second.listen_until(until(written + 100)));
  EXPECT_EQ(second.said, numbers_from(written + 1 - lease_depth, written + 100));
}

TEST_P(OtherReader, ThatDiesIsSucceededByOneThatGetsEveryResultFromItsFirstOn) {
  auto from = join_writer();
  auto writer = from->writer<ResultBatch>();
  std::uint64_t number = 0;
  for (int life = 0; life < 2; ++life) {
    auto reader = start("result", 0, "read");
    write_until_heard(*writer, reader, number);
    for (const auto last = number + 100; number < last;) write(*writer, batch(++number));
    ASSERT_TRUE(reader.listen_until(until(number)));
    expect_unbroken(reader.said);
  }
}

INSTANTIATE_TEST_SUITE_P(Port, OtherReader, ::testing::ValuesIn(network_pairs()), pair_name);

class OtherWriter : public World {
 protected:
  OtherProgram start(const std::string& topic, std::uint64_t first, std::uint64_t last, int milliseconds) {
    return {options(GetParam().writer, ""),
            {topic, "0", "write", std::to_string(first), std::to_string(last), std::to_string(milliseconds)}};
  }
};

TEST_P(OtherWriter, ThatDiesIsSucceededByOneWhoseHistoryArrivesOnce) {
  auto to = join_reader();
  Inbox<Lease> inbox(*to);
  Numbers expected;
  for (std::uint64_t life = 1; life <= 3; ++life) {
    auto writer = start("lease", 1000 * life + 1, 1000 * life + 100, 0);
    ASSERT_TRUE(take_until(inbox, 1000 * life + 100));
    const auto numbers = numbers_from(1000 * life + 1, 1000 * life + 100);
    expected.insert(expected.end(), numbers.begin(), numbers.end());
  }
  inbox.take();
  EXPECT_EQ(numbers_of(inbox.samples), expected);
}

TEST_P(OtherWriter, ThatDiesWhileItWritesIsSucceededByOneWhoseResultsArriveUnbroken) {
  auto to = join_reader();
  Inbox<ResultBatch> inbox(*to);
  constexpr std::uint64_t span = 1'000'000;
  for (std::uint64_t life = 1; life <= 2; ++life) {
    auto writer = start("result", life * span, life * span + 100'000, 1);
    ASSERT_TRUE(inbox.take_until([=](const auto& all) {
      return std::count_if(all.begin(), all.end(), [=](const auto& s) { return number_of(s) / span == life; }) >= 300;
    }));
  }
  for (std::uint64_t life = 1; life <= 2; ++life) {
    auto numbers = numbers_of(inbox.samples);
    std::erase_if(numbers, [=](auto number) { return number / span != life; });
    expect_unbroken(numbers);
  }
}

INSTANTIATE_TEST_SUITE_P(Port, OtherWriter, ::testing::ValuesIn(network_pairs()), pair_name);

}  // namespace
}  // namespace lamprey::messaging::conformance
