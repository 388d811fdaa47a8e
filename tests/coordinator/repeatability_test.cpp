// Which digests have to agree.
#include "tests/coordinator/hand_worker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::tests {
namespace {

using messaging::Verdict;

/// One job of an optimiser from outside, which only the same build repeats, and outcomes of it that differ.
class Repeatability : public testing::Test {
 protected:
  void SetUp() override {
    first.build = "0.1.0 (aaaaaaaaaaaa)";
    same.build = first.build;
    other.build = "0.1.0 (bbbbbbbbbbbb)";
    site.start_coordinator();
    site.submit(yaml);
    const auto leases = first.heartbeat();
    ASSERT_FALSE(leases.empty());
    origin = leases.back().origin;
    sweep = leases.back().sweep;
    same.heartbeat();
    other.heartbeat();
  }

  messaging::JobResult result(std::uint64_t number, double total) const {
    messaging::JobResult made;
    made.job = number;
    made.identity = experiment::identity(grid.job(number));
    made.outcome.cycles = 40;
    made.outcome.initial.total = made.outcome.final.total = total;
    made.outcome.evolved = made.outcome.highest = made.outcome.final;
    made.digest = experiment::outcome_digest(made.identity, made.outcome);
    return made;
  }

  Verdict verdict(HandWorker& worker, const messaging::JobResult& sent) {
    const auto answers = worker.send(origin, sweep, sent);
    if (answers.size() != 1) throw std::runtime_error(std::to_string(answers.size()) + " answers");
    return answers[0].verdict;
  }

  std::uint64_t divergences() { return site.number("SELECT count(*) FROM divergence"); }

  std::string yaml =
      "name: outside\nseed: 7\nbase: {cycles: 40}\ngrids:\n  - {trainer: [pagmo_sga]}\n  - {trainer: [rtea]}\n";
  experiment::SweepGrid grid{experiment::parse_sweep(yaml, "test").specification};
  Site site;
  HandWorker first{site, 0x71};
  HandWorker same{site, 0x72};
  HandWorker other{site, 0x73};
  messaging::Origin origin;
  experiment::Id128 sweep;
};

TEST_F(Repeatability, SameBuildJobOfAnotherBuildIsNoDivergence) {
  ASSERT_EQ(verdict(first, result(0, 1)), Verdict::committed);
  EXPECT_EQ(verdict(other, result(0, 2)), Verdict::duplicate);
  EXPECT_EQ(divergences(), 0U);
  EXPECT_EQ(site.number("SELECT count(*) FROM result WHERE final_total = 1 AND repeatability = 'same_build'"), 1U);
}

TEST_F(Repeatability, SameBuildJobOfTheSameBuildMustAgree) {
  ASSERT_EQ(verdict(first, result(0, 1)), Verdict::committed);
  EXPECT_EQ(verdict(same, result(0, 1)), Verdict::duplicate);
  EXPECT_EQ(verdict(same, result(0, 2)), Verdict::divergent);
  EXPECT_EQ(divergences(), 1U);
}

TEST_F(Repeatability, BitwiseJobMustAgreeWhateverTheBuild) {
  ASSERT_EQ(verdict(first, result(1, 1)), Verdict::committed);
  EXPECT_EQ(verdict(other, result(1, 2)), Verdict::divergent);
  EXPECT_EQ(divergences(), 1U);
}

TEST_F(Repeatability, HoldsForASweepThatHasEndedAndAWorkerThatIsGone) {
  ASSERT_EQ(verdict(first, result(0, 1)), Verdict::committed);
  ASSERT_EQ(verdict(first, result(1, 1)), Verdict::committed);
  site.kill_coordinator();
  site.start_coordinator();
  same.heartbeat();
  other.heartbeat();
  EXPECT_EQ(verdict(other, result(0, 2)), Verdict::duplicate);
  EXPECT_EQ(divergences(), 0U);
  EXPECT_EQ(verdict(same, result(0, 2)), Verdict::divergent);
  EXPECT_EQ(verdict(other, result(1, 2)), Verdict::divergent);
  EXPECT_EQ(divergences(), 2U);
}

}  // namespace
}  // namespace lamprey::tests
