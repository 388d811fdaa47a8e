#include "experiment/outcome.hpp"

#include <bit>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::experiment {
namespace {

Digest example_identity() {
  Digest digest{};
  for (std::size_t i = 0; i < digest.size(); ++i) digest[i] = static_cast<std::uint8_t>(i);
  return digest;
}

Outcome example() {
  return {.expected = {80, 60, 83, 223},
          .initial = {50, 10, 70.5, 130.5},
          .evolved = {60, 10, 71, 141},
          .highest = {60, 10, 71, 141},
          .final = {60, 10, 71, 141},
          .cycles = 4,
          .accepted = 1,
          .successes = 1,
          .success_rate = 0.25,
          .trace = {{2, {60, 10, 71, 141}}}};
}

std::string little_endian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xff);
  return text;
}

std::string real(double value) {
  return little_endian(std::bit_cast<std::uint64_t>(value), 8);
}

std::string score(double stability, double distance, double fuel, double total) {
  return real(stability) + real(distance) + real(fuel) + real(total);
}

TEST(OutcomeDigest, IsTheWorkedExampleOfTheFormatsPage) {
  std::string hashed = "lamprey-outcome/1\n";
  for (const auto byte : example_identity()) hashed += static_cast<char>(byte);
  hashed += score(80, 60, 83, 223) + score(50, 10, 70.5, 130.5);
  for (int i = 0; i < 3; ++i) hashed += score(60, 10, 71, 141);
  hashed += little_endian(4, 4) + little_endian(1, 4) + little_endian(1, 4) + real(0.25);
  hashed += little_endian(2, 4) + score(60, 10, 71, 141);

  EXPECT_EQ(hashed.size(), 18U + 32 + 160 + 12 + 8 + 36);
  EXPECT_EQ(outcome_digest(example_identity(), example()), sha256(std::string_view(hashed)));
  EXPECT_EQ(to_hex(outcome_digest(example_identity(), example())),
            "1f60da3c4688fd2de16d8466daff065edf6c4a3e8cdeafe67423133fa21163c8");
}

TEST(OutcomeDigest, MeasuresFollowTheTraceAsTheSecondExampleOfTheFormatsPageHasIt) {
  Outcome outcome = example();
  outcome.measures = {{"recovered", 0, 1}, {"recovery_cycles", 0, 17}};
  EXPECT_EQ(to_hex(outcome_digest(example_identity(), outcome)),
            "e86eba78ba77ba0c79afc30bddfbd8e98218aa38c33eb9be2b8ea260576f434d");
}

TEST(OutcomeDigest, CoversTheIdentityAndEveryField) {
  std::vector<std::function<void(Outcome&)>> changes;
  for (Score Outcome::*part :
       {&Outcome::expected, &Outcome::initial, &Outcome::evolved, &Outcome::highest, &Outcome::final}) {
    for (double Score::*component : {&Score::stability, &Score::distance, &Score::fuel, &Score::total}) {
      changes.emplace_back([=](Outcome& outcome) { (outcome.*part).*component += 0.5; });
    }
  }
  changes.emplace_back([](Outcome& outcome) { ++outcome.cycles; });
  changes.emplace_back([](Outcome& outcome) { ++outcome.accepted; });
  changes.emplace_back([](Outcome& outcome) { ++outcome.successes; });
  changes.emplace_back([](Outcome& outcome) { outcome.success_rate = 0.5; });
  changes.emplace_back([](Outcome& outcome) { ++outcome.trace[0].cycle; });
  for (double Score::*component : {&Score::stability, &Score::distance, &Score::fuel, &Score::total}) {
    changes.emplace_back([=](Outcome& outcome) { outcome.trace[0].score.*component += 0.5; });
  }
  changes.emplace_back([](Outcome& outcome) { outcome.trace.push_back(outcome.trace[0]); });
  changes.emplace_back([](Outcome& outcome) { outcome.trace.clear(); });
  const auto with_measures = [&](const std::vector<Measure>& measures) {
    changes.emplace_back([=](Outcome& outcome) { outcome.measures = measures; });
  };
  with_measures({{"a", 0, 1}});
  with_measures({{"b", 0, 1}});
  with_measures({{"a", 1, 1}});
  with_measures({{"a", 0, 2}});
  with_measures({{"aa", 0, 1}});
  with_measures({{"a", 0, 1}, {"b", 0, 1}});

  std::set<Digest> digests{outcome_digest(example_identity(), example()), outcome_digest({}, example())};
  ASSERT_EQ(digests.size(), 2U);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Outcome outcome = example();
    changes[i](outcome);
    EXPECT_TRUE(digests.insert(outcome_digest(example_identity(), outcome)).second) << i;
  }
}

TEST(MeasuresFault, ThereIsNoneInSortedNamedNumbers) {
  EXPECT_EQ(measures_fault({}), "");
  const std::vector<Measure> good = {
      {"a", 0, 0}, {"a", 4294967295U, -1e300}, {"a_1", 0, 5e-324}, {std::string(64, 'b'), 3, 1}};
  EXPECT_EQ(measures_fault(good), "");
}

TEST(MeasuresFault, NamesWhatIsWrong) {
  const auto fault = [](const std::vector<Measure>& measures) { return measures_fault(measures); };
  for (const std::string& name : {std::string(), std::string("A"), std::string("a b"), std::string("a\"b"),
                                  std::string("gr\xc3\xb6\xc3\x9f") + "e", std::string(65, 'b')}) {
    EXPECT_NE(fault({{name, 0, 1}}), "") << name;
  }
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(fault({{"a", 7, infinity}}), "the measure a 7 is not a finite number");
  EXPECT_EQ(fault({{"a", 7, std::nan("")}}), "the measure a 7 is not a finite number");
  EXPECT_EQ(fault({{"a", 7, -0.0}}), "the measure a 7 is a negative zero");
  EXPECT_EQ(fault({{"a", 7, 1}, {"a", 7, 2}}), "the measure a 7 comes twice or is out of order");
  EXPECT_EQ(fault({{"a", 8, 1}, {"a", 7, 2}}), "the measure a 7 comes twice or is out of order");
  EXPECT_EQ(fault({{"b", 0, 1}, {"a", 7, 2}}), "the measure a 7 comes twice or is out of order");
}

}  // namespace
}  // namespace lamprey::experiment
