#include "messaging/qos.hpp"
#include "messaging/tuning.hpp"
#include "tests/conformance/world.hpp"

#include <cstddef>
#include <gtest/gtest.h>
#include <memory>
#include <thread>
#include <vector>

/// Payloads from 1 octet to 1 MB: whole in one message, and cut into fragments at every bound there is.
namespace lamprey::messaging::conformance {
namespace {

constexpr std::size_t megabyte = 1024 * 1024;

/// Octets without a period that a fragment could have.
std::vector<std::uint8_t> octets(std::size_t size) {
  std::vector<std::uint8_t> all(size);
  std::uint32_t state = static_cast<std::uint32_t>(size);
  for (auto& octet : all) {
    state = state * 1664525u + 1013904223u;
    octet = static_cast<std::uint8_t>(state >> 24);
  }
  return all;
}

std::vector<std::uint8_t>& payload_of(SweepSpecification& sample) {
  return sample.specification;
}
std::vector<std::uint8_t>& payload_of(Lease& sample) {
  return sample.checkpoint;
}
std::vector<std::uint8_t>& payload_of(ResultBatch& sample) {
  sample.results.resize(1);
  return sample.results[0].recording;
}
std::vector<std::uint8_t>& payload_of(Checkpoint& sample) {
  return sample.state;
}
std::vector<std::uint8_t>& payload_of(Request& sample) {
  return sample.payload;
}
std::vector<std::uint8_t>& payload_of(Reply& sample) {
  return sample.payload;
}

template <class Sample>
Sample of_size(std::size_t size) {
  Sample sample;
  payload_of(sample) = octets(size);
  return sample;
}

/// Every size at which a head and a payload can just fit into a message or fragment, and some far from there.
std::vector<std::size_t> sizes() {
  std::vector<std::size_t> all{1, 2, 3, 4, 7, 8, 100, 500};
  const auto range = [&](std::size_t first, std::size_t last) {
    for (std::size_t size = first; size <= last; ++size) all.push_back(size);
  };
  range(maximum_fragment_bytes - 512, maximum_message_bytes + 64);
  range(2 * maximum_fragment_bytes - 512, 2 * maximum_fragment_bytes + 8);
  for (std::size_t size = 64 * 1024 - 1024; size <= 64 * 1024 + 32; size += 8) all.push_back(size);
  for (const std::size_t size : {megabyte / 10, megabyte / 2, megabyte - 1, megabyte}) all.push_back(size);
  return all;
}

class Size : public World {};

TEST_P(Size, ResultsOfEverySizeArriveWholeInOneStream) {
  const auto all = sizes();
  auto from = join_writer();
  auto to = join_reader();
  auto writer = from->writer<ResultBatch>();
  Inbox<ResultBatch> inbox(*to);
  meet(*writer, inbox, ResultBatch{});
  std::jthread thread([&] {
    for (std::size_t i = 0; i < all.size(); ++i) {
      auto sample = of_size<ResultBatch>(all[i]);
      sample.sequence = i + 1;
      write(*writer, sample);
    }
  });
  EXPECT_TRUE(inbox.take_until([&](const auto& some) { return !some.empty() && some.back().sequence == all.size(); }));
  std::erase(inbox.samples, ResultBatch{});
  ASSERT_EQ(inbox.samples.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto expected = of_size<ResultBatch>(all[i]);
    expected.sequence = i + 1;
    ASSERT_TRUE(inbox.samples[i] == expected) << all[i] << " octets";
  }
}

/// One at a time, since most of these topics keep only the last few.
template <class Sample>
void expect_sizes(Participant& from, Participant& to) {
  SCOPED_TRACE(Topic<Sample>::name);
  auto writer = from.writer<Sample>();
  Inbox<Sample> inbox(to);
  meet(*writer, inbox, Sample{});
  for (const std::size_t size : {std::size_t{1}, std::size_t{1024}, std::size_t{maximum_fragment_bytes},
                                 std::size_t{maximum_message_bytes}, std::size_t{64 * 1024}, megabyte}) {
    const auto sample = of_size<Sample>(size);
    inbox.samples.clear();
    write(*writer, sample);
    ASSERT_TRUE(inbox.take_until([&](const auto& all) { return !all.empty() && all.back() != Sample{}; })) << size;
    EXPECT_TRUE(inbox.samples.back() == sample) << size << " octets";
  }
}

TEST_P(Size, PayloadFromOneOctetToAMegabyteArrivesInEveryTopicThatHasOne) {
  auto from = join_writer();
  auto to = join_reader();
  expect_sizes<SweepSpecification>(*from, *to);
  expect_sizes<Lease>(*from, *to);
  expect_sizes<ResultBatch>(*from, *to);
  expect_sizes<Checkpoint>(*from, *to);
  expect_sizes<Request>(*from, *to);
  expect_sizes<Reply>(*from, *to);
}

TEST_P(Size, LateReaderGetsAMegabyteThatWasWrittenBefore) {
  auto from = join_writer();
  auto writer = from->writer<Reply>();
  const auto sample = of_size<Reply>(megabyte);
  write(*writer, sample);
  auto to = join_reader();
  Inbox<Reply> inbox(*to);
  ASSERT_TRUE(inbox.take_until_size(1));
  EXPECT_TRUE(inbox.samples[0] == sample);
}

INSTANTIATE_TEST_SUITE_P(Port, Size, ::testing::ValuesIn(all_pairs()), pair_name);
INSTANTIATE_TEST_SUITE_P(PortWithTheSettingsOfANetwork, Size, ::testing::ValuesIn(pairs_with_network_settings()),
                         pair_name);

}  // namespace
}  // namespace lamprey::messaging::conformance
