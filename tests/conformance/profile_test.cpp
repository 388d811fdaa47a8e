#include "messaging/qos.hpp"
#include "tests/conformance/numbered.hpp"
#include "tests/conformance/world.hpp"

#include <algorithm>
#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <set>
#include <string>
#include <vector>

/// That each topic behaves as its profile in messaging/qos.hpp says.
namespace lamprey::messaging::conformance {
namespace {

constexpr std::uint64_t keys = 3;
/// Of markers: a key that no other sample has, so that none takes another's place.
constexpr std::uint64_t marker_key = keys;
constexpr std::uint64_t marker = 1'000'000;

class Profile : public World {};

/// Writes the marker until it arrives; everything written before by a reliable writer has arrived then, too.
template <class Sample>
void write_until_marker_arrives(Writer<Sample>& writer, Inbox<Sample>& inbox) {
  const auto arrived = [&] { return !inbox.samples.empty() && number_of(inbox.samples.back()) == marker; };
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (!arrived()) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline) << "no sample arrives";
    write(writer, numbered<Sample>(marker, marker_key));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    inbox.take();
  }
}

/// Of samples 1 … last, whose keys take turns.
template <class Sample>
std::vector<std::uint64_t> promised_to_late_readers(std::uint64_t last) {
  constexpr QosProfile profile = Topic<Sample>::profile;
  if (!profile.transient_local) return {};
  return numbers_from(last + 1 - profile.depth * (Keyed<Sample> ? keys : 1), last);
}

template <class Sample>
void expect_promised_history(Participant& from, Participant& to) {
  SCOPED_TRACE(Topic<Sample>::name);
  auto writer = from.writer<Sample>();
  const std::uint64_t last = Topic<Sample>::profile.depth * keys + 7;
  for (std::uint64_t i = 1; i <= last; ++i) write(*writer, numbered<Sample>(i, i % keys));

  Inbox<Sample> inbox(to);
  const auto promised = promised_to_late_readers<Sample>(last);
  ASSERT_TRUE(inbox.take_until_size(promised.size()));
  write_until_marker_arrives(*writer, inbox);
  auto numbers = numbers_of(inbox.samples);
  std::erase(numbers, marker);
  if (Keyed<Sample>) std::sort(numbers.begin(), numbers.end());  // the order is that within a key
  EXPECT_EQ(numbers, promised);
}

TEST_P(Profile, LateReaderGetsAsMuchHistoryAsTheTopicsProfileSays) {
  auto from = join_writer();
  auto to = join_reader();
  for_each_topic([&]<class Sample>(std::type_identity<Sample>) { expect_promised_history<Sample>(*from, *to); });
}

/// What a reader held when it was asked, after nothing had arrived for a while.
template <class Sample>
std::vector<Sample> take_when_quiet(Reader<Sample>& reader, Signal& signal) {
  while (signal.wait_for(std::chrono::milliseconds(100))) {
  }
  return reader.take(2 * maximum_untaken);
}

template <class Sample>
void expect_no_more_than_promised(const std::vector<Sample>& held) {
  if constexpr (Keyed<Sample>) {
    std::set<Id128> seen;
    for (const auto& sample : held) EXPECT_TRUE(seen.insert(key_of(sample)).second) << "two samples of one key";
  } else {
    EXPECT_LE(held.size(), Topic<Sample>::profile.untaken);
  }
}

/// The reader takes nothing while many more samples arrive than it may hold.
template <class Sample>
void expect_bounded_backlog(Participant& from, Participant& to) {
  constexpr QosProfile profile = Topic<Sample>::profile;
  SCOPED_TRACE(Topic<Sample>::name);
  auto writer = from.writer<Sample>();
  const auto signal = std::make_shared<Signal>();
  auto reader = to.reader<Sample>(signal);
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (reader->take().empty()) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline) << "writer and reader did not meet";
    write(*writer, numbered<Sample>(marker, marker_key));
    signal->wait_for(std::chrono::milliseconds(20));
  }

  std::uint64_t last = 0;
  const std::uint64_t most = Keyed<Sample> ? 5 * keys : profile.untaken + 100;
  while (last < most) {
    const WriteResult result = writer->write(numbered<Sample>(last + 1, last % keys));
    if (result.kind == WriteResult::Kind::full) break;
    ASSERT_TRUE(result) << result.error;
    ++last;
  }
  if (!profile.reliable) {
    expect_no_more_than_promised(take_when_quiet(*reader, *signal));
    return;
  }
  std::set<std::uint64_t> taken;
  while (!taken.contains(last)) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline) << "the newest sample does not arrive";
    const auto held = take_when_quiet(*reader, *signal);
    expect_no_more_than_promised(held);
    for (const auto number : numbers_of(held)) {
      EXPECT_TRUE(number == marker || taken.insert(number).second) << "sample " << number << " came twice";
    }
  }
}

TEST_P(Profile, ReaderThatDoesNotTakeHoldsTheNewestSamplesAndAsManyAsTheTopicsProfileSays) {
  auto from = join_writer();
  auto to = join_reader();
  for_each_topic([&]<class Sample>(std::type_identity<Sample>) { expect_bounded_backlog<Sample>(*from, *to); });
}

INSTANTIATE_TEST_SUITE_P(Port, Profile, ::testing::ValuesIn(all_pairs()), pair_name);

}  // namespace
}  // namespace lamprey::messaging::conformance
