#include "messaging/qos.hpp"
#include "tests/conformance/numbered.hpp"
#include "tests/conformance/world.hpp"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <thread>
#include <vector>

/// Several writers at once, as fast as they can.
namespace lamprey::messaging::conformance {
namespace {

/// Numbers of writer w: w · span + 1, 2, …; w · span itself is its marker.
constexpr std::uint64_t span = 1'000'000;

class Burst : public World {};

/// Repeats the writer's marker until it arrives.
template <class Sample>
void meet_writer(Writer<Sample>& writer, Inbox<Sample>& inbox, std::uint64_t number) {
  const Sample marker = numbered<Sample>(number * span, number);
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (std::find(inbox.samples.begin(), inbox.samples.end(), marker) == inbox.samples.end()) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline) << "writer and reader did not meet";
    write(writer, marker);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    inbox.take();
  }
}

/// What arrived of each writer, by its number, without its markers.
template <class Sample>
std::map<std::uint64_t, std::vector<std::uint64_t>> by_writer(const std::vector<Sample>& samples) {
  std::map<std::uint64_t, std::vector<std::uint64_t>> all;
  for (const auto number : numbers_of(samples)) {
    if (number % span != 0) all[number / span].push_back(number % span);
  }
  return all;
}

TEST_P(Burst, TwentyThousandResultsOfFourWritersArriveOnceAndInOrder) {
  constexpr std::uint64_t writers = 4;
  constexpr std::uint64_t bursts = 5;
  // Together fewer than a reader holds, so that nothing depends on how soon they are taken.
  constexpr std::uint64_t burst = 1000;
  static_assert(writers * (burst + 10) <= maximum_untaken);
  auto to = join_reader();
  Inbox<ResultBatch> inbox(*to);
  std::array<std::unique_ptr<Participant>, writers> from;
  std::array<std::unique_ptr<Writer<ResultBatch>>, writers> ends;
  for (std::uint64_t i = 0; i < writers; ++i) {
    from[i] = join_writer();
    ends[i] = from[i]->writer<ResultBatch>();
    meet_writer(*ends[i], inbox, i + 1);
  }
  const auto arrived = [](const auto& samples) {
    return std::count_if(samples.begin(), samples.end(), [](const auto& s) { return number_of(s) % span != 0; });
  };
  for (std::uint64_t round = 0; round < bursts; ++round) {
    std::vector<std::jthread> threads;
    for (std::uint64_t i = 0; i < writers; ++i) {
      threads.emplace_back([&, i] {
        for (std::uint64_t n = round * burst + 1; n <= (round + 1) * burst; ++n) {
          write(*ends[i], numbered<ResultBatch>((i + 1) * span + n));
        }
      });
    }
    const auto expected = static_cast<std::ptrdiff_t>((round + 1) * burst * writers);
    ASSERT_TRUE(inbox.take_until([&](const auto& all) { return arrived(all) >= expected; })) << "round " << round;
  }
  const auto received = by_writer(inbox.samples);
  EXPECT_EQ(received.size(), writers);
  for (const auto& [writer, numbers] : received) {
    EXPECT_EQ(numbers, numbers_from(1, bursts * burst)) << "of writer " << writer;
  }
}

/// Keep-last may skip samples of a burst, and best effort may lose them; but none comes twice or late, and of a
/// reliable topic the last one comes.
template <class Sample>
void expect_newest_of_bursts(Participant& from, Participant& other, Participant& to) {
  // Together fewer than the reader holds: beyond that, one writer's samples take the place of the other's.
  constexpr std::uint64_t burst = Topic<Sample>::profile.untaken / 4;
  constexpr bool reliable = Topic<Sample>::profile.reliable;
  SCOPED_TRACE(Topic<Sample>::name);
  Inbox<Sample> inbox(to);
  auto writer = from.writer<Sample>();
  auto other_writer = other.writer<Sample>();
  meet_writer(*writer, inbox, 1);
  meet_writer(*other_writer, inbox, 2);
  const auto write_burst = [](Writer<Sample>& end, std::uint64_t number) {
    for (std::uint64_t i = 1; i <= burst; ++i) write(end, numbered<Sample>(number * span + i, number));
  };
  {
    const std::jthread thread([&] { write_burst(*writer, 1); });
    const std::jthread other_thread([&] { write_burst(*other_writer, 2); });
    const auto has = [](const auto& samples, std::uint64_t number) {
      return std::any_of(samples.begin(), samples.end(), [=](const auto& s) { return number_of(s) == number; });
    };
    if (reliable) {
      EXPECT_TRUE(inbox.take_until(
          [&](const auto& samples) { return has(samples, span + burst) && has(samples, 2 * span + burst); }));
    }
  }
  inbox.take();
  for (const auto& [number, numbers] : by_writer(inbox.samples)) {
    const auto unordered = std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>());
    EXPECT_EQ(unordered, numbers.end()) << "writer " << number << ": " << *unordered << " came before "
                                        << *std::next(unordered);
  }
}

TEST_P(Burst, NewestSampleOfEachWriterArrivesInEveryTopic) {
  auto from = join_writer();
  auto other = join_writer();
  auto to = join_reader();
  for_each_topic(
      [&]<class Sample>(std::type_identity<Sample>) { expect_newest_of_bursts<Sample>(*from, *other, *to); });
}

INSTANTIATE_TEST_SUITE_P(Port, Burst, ::testing::ValuesIn(all_pairs()), pair_name);

}  // namespace
}  // namespace lamprey::messaging::conformance
