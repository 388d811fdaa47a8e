#include "experiment/outcome.hpp"

#include <bit>
#include <functional>
#include <gtest/gtest.h>
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

  std::set<Digest> digests{outcome_digest(example_identity(), example()), outcome_digest({}, example())};
  ASSERT_EQ(digests.size(), 2U);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Outcome outcome = example();
    changes[i](outcome);
    EXPECT_TRUE(digests.insert(outcome_digest(example_identity(), outcome)).second) << i;
  }
}

}  // namespace
}  // namespace lamprey::experiment
