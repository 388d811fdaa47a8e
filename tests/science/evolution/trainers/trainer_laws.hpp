#pragma once

#include "tests/science/evolution/trainers/known_problems.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace lamprey::science::evolution::known_problems {

/// What holds for every trainer. Instantiate with the trainers; one source of a program can.
class TrainerLaws : public testing::TestWithParam<Named> {
 protected:
  static constexpr std::uint32_t evaluations = 230;

  Seen run(std::uint64_t key, std::uint32_t count = evaluations, std::uint32_t portion = 1'000'000) const {
    return train(*GetParam().make(), problem, key, count, portion);
  }

  Minimisation problem = mixed();
};

TEST_P(TrainerLaws, TheSameStreamGivesTheSameRunAndAnotherAnother) {
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1).asked, run(2).asked);
}

TEST_P(TrainerLaws, ARunIsAPrefixOfEveryLongerOne) {
  const Seen whole = run(3);
  for (const std::uint32_t shorter : {1U, 2U, 7U, 39U, 40U, 41U, 79U, 100U, 101U, 160U, 229U}) {
    const Seen cut = run(3, shorter);
    EXPECT_TRUE(std::equal(cut.costs.begin(), cut.costs.end(), whole.costs.begin())) << shorter;
    EXPECT_TRUE(std::equal(cut.asked.begin(), cut.asked.end(), whole.asked.begin())) << shorter;
  }
}

TEST_P(TrainerLaws, HowEvaluationsArePortionedChangesNothing) {
  const Seen whole = run(4);
  for (const std::uint32_t portion : {1U, 3U, 64U}) EXPECT_EQ(run(4, evaluations, portion), whole) << portion;
}

TEST_P(TrainerLaws, AStepHasAtLeastOneEvaluationAndAtMostItsBudgetEachWithAReport) {
  const auto trainer = GetParam().make();
  const Training given = training(problem, 5);
  trainer->begin(given);
  EXPECT_EQ(problem.asked.size(), 1U);
  std::vector<CycleReport> reports;
  for (std::uint32_t budget = 1; budget < 60; ++budget) {
    const std::size_t before = reports.size();
    trainer->advance(given, budget, reports);
    EXPECT_GE(reports.size(), before + 1);
    EXPECT_LE(reports.size(), before + budget);
  }
  EXPECT_EQ(problem.asked.size(), 1 + reports.size() + GetParam().uncounted);
}

TEST_P(TrainerLaws, EveryCandidateIsWithinTheBounds) {
  const auto& genes = problem.plan().genes;
  for (const auto& candidate : run(6).asked) {
    ASSERT_EQ(candidate.size(), genes.size());
    for (std::size_t gene = 0; gene < genes.size(); ++gene) {
      EXPECT_GE(candidate[gene], genes[gene].minimum);
      EXPECT_LE(candidate[gene], genes[gene].maximum);
    }
  }
}

TEST_P(TrainerLaws, AcceptedIsWhatIsStrictlyBetterThanEverythingBeforeAndIsWhatItsGenesAre) {
  const Seen seen = run(7);
  double best = seen.first;
  for (std::size_t cycle = 0; cycle < seen.costs.size(); ++cycle) {
    EXPECT_EQ(seen.accepted[cycle], seen.costs[cycle] < best) << cycle;
    best = std::min(best, seen.costs[cycle]);
  }
  EXPECT_EQ(problem.at(seen.genes), best);
}

TEST_P(TrainerLaws, ACloneGoesOnAsItsOriginalDoesAndLeavesItAlone) {
  for (const std::uint32_t before : {0U, 17U, 95U}) {
    const auto original = GetParam().make();
    const Training given = training(problem, 8);
    original->begin(given);
    std::vector<CycleReport> reports;
    while (reports.size() < before) {
      original->advance(given, before - static_cast<std::uint32_t>(reports.size()), reports);
    }
    const auto clone = original->clone();
    const auto go_on = [&](Trainer& trainer) {
      problem.asked.clear();
      std::vector<CycleReport> more;
      while (more.size() < 100) trainer.advance(given, 100 - static_cast<std::uint32_t>(more.size()), more);
      return problem.asked;
    };
    const auto of_clone = go_on(*clone);
    EXPECT_EQ(go_on(*original), of_clone) << before;
    EXPECT_TRUE(std::ranges::equal(original->genes(), clone->genes())) << before;
  }
}

TEST_P(TrainerLaws, ARestoredTrainerGoesOnAsTheSavedOneDoes) {
  if (!GetParam().make()->can_be_saved()) GTEST_SKIP() << "it cannot be saved";
  const Seen whole = run(9);
  const Training given = training(problem, 9);
  for (std::uint32_t before = 0; before < evaluations; ++before) {
    const auto original = GetParam().make();
    original->begin(given);
    std::vector<CycleReport> reports;
    while (reports.size() < before) original->advance(given, 1, reports);
    saving::Writer writer;
    original->save(given, writer);
    const auto octets = std::move(writer).take();

    const auto restored = GetParam().make();
    saving::Reader reader(octets);
    restored->restore(given, before, reader);
    EXPECT_NO_THROW(reader.end());
    EXPECT_TRUE(std::ranges::equal(restored->genes(), original->genes())) << before;
    saving::Writer again;
    restored->save(given, again);
    EXPECT_EQ(std::move(again).take(), octets) << before;

    while (reports.size() < evaluations) {
      restored->advance(given, evaluations - static_cast<std::uint32_t>(reports.size()), reports);
    }
    for (std::size_t cycle = 0; cycle < evaluations; ++cycle) {
      ASSERT_EQ(-reports[cycle].fitness.distance, whole.costs[cycle]) << before << ", " << cycle;
      ASSERT_EQ(reports[cycle].accepted, whole.accepted[cycle]) << before << ", " << cycle;
    }
  }
}

TEST_P(TrainerLaws, AStateThatIsCutShortOrHasAnotherNumberOfCyclesIsRefusedOrHarmless) {
  if (!GetParam().make()->can_be_saved()) GTEST_SKIP() << "it cannot be saved";
  const Training given = training(problem, 10);
  const auto original = GetParam().make();
  original->begin(given);
  std::vector<CycleReport> reports;
  while (reports.size() < 133) original->advance(given, 1, reports);
  saving::Writer writer;
  original->save(given, writer);
  const auto octets = std::move(writer).take();
  for (std::size_t length = 0; length < octets.size(); ++length) {
    saving::Reader reader({octets.data(), length});
    EXPECT_THROW(GetParam().make()->restore(given, 133, reader), saving::Invalid) << length;
  }
  for (const std::uint32_t cycles : {0U, 1U, 4'000'000'000U}) {
    saving::Reader reader(octets);
    const auto restored = GetParam().make();
    try {
      restored->restore(given, cycles, reader);
    } catch (const saving::Invalid&) {
      continue;
    }
    restored->advance(given, 50, reports);
  }
}

inline std::string name_of(const testing::TestParamInfo<Named>& info) {
  return info.param.name;
}

}  // namespace lamprey::science::evolution::known_problems
