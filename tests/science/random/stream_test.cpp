#include "science/random/stream.hpp"

#include <Random123/philox.h>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

namespace lamprey::science::random {
namespace {

using Key = std::array<std::uint32_t, 2>;

/// Philox4x32-10 written from the paper, so that a new version of the library can't change our streams unnoticed.
Words philox(Words counter, Key key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t first = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t second = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {static_cast<std::uint32_t>(second >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(second),
               static_cast<std::uint32_t>(first >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(first)};
    key = {key[0] + 0x9E3779B9, key[1] + 0xBB67AE85};
  }
  return counter;
}

struct KnownAnswer {
  Words counter;
  Key key;
  Words answer;
};

// Random123's kat_vectors, philox4x32 with 10 rounds.
const KnownAnswer known_answers[] = {
    {{0, 0, 0, 0}, {0, 0}, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
    {{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff},
     {0xffffffff, 0xffffffff},
     {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
    {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
     {0xa4093822, 0x299f31d0},
     {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}},
};

TEST(Philox, OfTheLibraryGivesThePublishedAnswers) {
  for (const auto& [counter, key, answer] : known_answers) {
    const auto words = r123::Philox4x32()({{counter[0], counter[1], counter[2], counter[3]}}, {{key[0], key[1]}});
    EXPECT_EQ((Words{words[0], words[1], words[2], words[3]}), answer);
  }
}

TEST(Philox, FromThePaperGivesThePublishedAnswers) {
  for (const auto& [counter, key, answer] : known_answers) EXPECT_EQ(philox(counter, key), answer);
}

TEST(Stream, OfKeyZeroAtAddressZeroGivesThePublishedAnswer) {
  EXPECT_EQ(Stream(0).block(0, Purpose{0}, 0), known_answers[0].answer);
}

TEST(Stream, PutsCyclePurposeAndIndexIntoTheCounterAndTheLowHalfOfTheKeyFirst) {
  std::mt19937_64 generator(1);
  std::uniform_int_distribution<std::uint32_t> word;
  for (int i = 0; i < 1000; ++i) {
    const std::uint64_t key = generator();
    const std::uint32_t cycle = word(generator);
    const std::uint32_t index = word(generator);
    for (const Purpose purpose : {Purpose::disturbance_selection, Purpose::disturbance, Purpose::mutation_choice,
                                  Purpose::mutation, Purpose::acceptance}) {
      const Words expected = philox({cycle, static_cast<std::uint32_t>(purpose), index, 0},
                                    {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)});
      ASSERT_EQ(Stream(key).block(cycle, purpose, index), expected);
    }
  }
}

TEST(Stream, PurposesKeepTheirNumbers) {
  EXPECT_EQ(static_cast<std::uint32_t>(Purpose::disturbance_selection), 1U);
  EXPECT_EQ(static_cast<std::uint32_t>(Purpose::disturbance), 2U);
  EXPECT_EQ(static_cast<std::uint32_t>(Purpose::mutation_choice), 3U);
  EXPECT_EQ(static_cast<std::uint32_t>(Purpose::mutation), 4U);
  EXPECT_EQ(static_cast<std::uint32_t>(Purpose::acceptance), 5U);
}

TEST(Bounded, ReachesBothEndsAndNothingBeyond) {
  for (const std::uint32_t count : {1U, 2U, 6U, 8U, 21U, 0xffffffffU}) {
    EXPECT_EQ(bounded(0, count), 0U);
    EXPECT_EQ(bounded(0xffffffff, count), count - 1);
  }
}

TEST(Bounded, DiffersFromUniformByAtMostOneWordPerValue) {
  // Value v comes from the words ceil(v·2³²/n) .. ceil((v + 1)·2³²/n) − 1.
  for (const std::uint32_t count : {3U, 5U, 6U, 7U, 8U, 21U}) {
    const std::uint64_t words = std::uint64_t{1} << 32;
    for (std::uint64_t value = 0; value < count; ++value) {
      const std::uint64_t first = (value * words + count - 1) / count;
      const std::uint64_t end = ((value + 1) * words + count - 1) / count;
      EXPECT_EQ(bounded(static_cast<std::uint32_t>(first), count), value);
      EXPECT_EQ(bounded(static_cast<std::uint32_t>(end - 1), count), value);
      const std::uint64_t share = end - first;
      EXPECT_TRUE(share == words / count || share == words / count + 1);
    }
  }
}

TEST(Symmetric, CoversTheWholeRangeAndIsZeroForSizeZero) {
  std::set<int> values;
  for (std::uint64_t word = 0; word < (std::uint64_t{1} << 32); word += 0x01000001) {
    values.insert(symmetric(static_cast<std::uint32_t>(word), 10));
    EXPECT_EQ(symmetric(static_cast<std::uint32_t>(word), 0), 0);
  }
  EXPECT_EQ(values.size(), 21U);
  EXPECT_EQ(*values.begin(), -10);
  EXPECT_EQ(*values.rbegin(), 10);
}

TEST(Symmetric, IsUniformOverAStream) {
  const Stream stream(2006);
  std::map<int, int> counts;
  constexpr std::uint32_t blocks = 50'000;
  for (std::uint32_t cycle = 0; cycle < blocks; ++cycle) {
    for (const std::uint32_t word : stream.block(cycle, Purpose::mutation, 3)) ++counts[symmetric(word, 5)];
  }
  ASSERT_EQ(counts.size(), 11U);
  const double expected = 4.0 * blocks / 11;
  double chi_squared = 0;
  for (const auto& [value, count] : counts) chi_squared += (count - expected) * (count - expected) / expected;
  EXPECT_LT(chi_squared, 29.6);  // 10 degrees of freedom; exceeded by one stream of a thousand
}

TEST(UnitInterval, IsBelowOneAndHasFiftyThreeBits) {
  EXPECT_EQ(unit_interval(0, 0), 0.0);
  EXPECT_EQ(unit_interval(0, 1U << 11), 0x1p-53);
  EXPECT_EQ(unit_interval(0, (1U << 11) - 1), 0.0);
  EXPECT_EQ(unit_interval(0x80000000, 0), 0.5);
  EXPECT_EQ(unit_interval(0xffffffff, 0xffffffff), 1 - 0x1p-53);
}

}  // namespace
}  // namespace lamprey::science::random
