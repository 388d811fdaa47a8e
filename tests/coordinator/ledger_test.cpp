#include "coordinator/ledger.hpp"

#include <gtest/gtest.h>
#include <map>

namespace lamprey::coordinator {
namespace {

constexpr Id128 database{1, 2};
constexpr Id128 sweep{3, 4};

class LedgerTest : public testing::Test {
 protected:
  Clock::time_point now{std::chrono::hours{1}};
  Ledger ledger{LedgerOptions{}, now, false, std::uint64_t{1} << 32};

  messaging::WorkerStatus status(std::uint64_t worker, std::uint64_t heartbeat, std::uint32_t window = 2) {
    messaging::WorkerStatus sample;
    sample.origin = {database, 1, worker, experiment::science_version};
    sample.heartbeat = heartbeat;
    sample.window = window;
    return sample;
  }
  void beat(std::uint64_t worker, std::uint64_t heartbeat, std::uint32_t window = 2) {
    ledger.heartbeat(status(worker, heartbeat, window), database, now);
  }
  /// The worker joins, gets job 0 and reports it running; its lease's number.
  std::uint64_t grant_and_run(std::uint64_t worker) {
    beat(worker, 1, 1);
    const auto grants = ledger.grant(now);
    EXPECT_EQ(grants.size(), 1U);
    if (grants.empty()) return 0;
    auto running = status(worker, 2, 1);
    running.running = {{sweep, 0}};
    running.leases = {{database, 1, grants[0].lease.lease, sweep, {{0, 1}}}};
    ledger.heartbeat(running, database, now);
    return grants[0].lease.lease;
  }
};

TEST_F(LedgerTest, FirstLeasesAreSingleJobsAndLaterOnesLastAboutASecond) {
  ledger.add_sweep(sweep, JobRanges(0, 100'000), {});
  beat(7, 1, 4);
  auto grants = ledger.grant(now);
  ASSERT_EQ(grants.size(), 4U);
  for (const auto& grant : grants) EXPECT_EQ(grant.lease.ranges.at(0).count, 1U);
  for (const auto& grant : grants) ledger.ended(sweep, grant.lease.ranges[0].first, grant.lease.lease, 0.004);
  grants = ledger.grant(now);
  ASSERT_EQ(grants.size(), 4U);
  EXPECT_EQ(grants[0].lease.ranges.at(0).count, 250U);
}

TEST_F(LedgerTest, TowardsTheEndLeasesGetSmallerSoThatAllFinishTogether) {
  ledger.add_sweep(sweep, JobRanges(0, 40), {});
  beat(7, 1, 2);
  beat(8, 1, 2);
  for (const auto& grant : ledger.grant(now)) ledger.ended(sweep, grant.lease.ranges[0].first, grant.lease.lease, 1e-6);
  for (const auto& grant : ledger.grant(now)) EXPECT_LE(grant.lease.ranges[0].count, 5U);
}

TEST_F(LedgerTest, EveryJobIsInExactlyOneLease) {
  JobRanges jobs(0, 1'000);
  jobs.remove(100, 50);
  ledger.add_sweep(sweep, jobs, {});
  for (std::uint64_t worker = 1; worker <= 5; ++worker) beat(worker, 1, 8);
  JobRanges granted;
  std::uint64_t count = 0;
  for (auto grants = ledger.grant(now); !grants.empty(); grants = ledger.grant(now)) {
    for (const auto& grant : grants) {
      for (const auto& range : grant.lease.ranges) {
        granted.add(range.first, range.count);
        count += range.count;
        for (std::uint64_t job = range.first; job < range.first + range.count; ++job) {
          ledger.ended(sweep, job, grant.lease.lease, 0.01);
        }
      }
    }
  }
  EXPECT_EQ(count, 950U);
  EXPECT_EQ(granted.size(), 950U);
  EXPECT_EQ(ledger.pending(sweep) + ledger.leased(sweep), 0U);
}

TEST_F(LedgerTest, AfterARestartNothingIsGrantedBeforeWorkersHaveReported) {
  Ledger restarted(LedgerOptions{}, now, true, std::uint64_t{2} << 32);
  restarted.add_sweep(sweep, JobRanges(0, 10), {});
  restarted.heartbeat(status(7, 1), database, now);
  EXPECT_TRUE(restarted.grant(now + std::chrono::seconds{1}).empty());
  EXPECT_FALSE(restarted.grant(now + std::chrono::seconds{2}).empty());
}

TEST_F(LedgerTest, AdoptsALeaseOfAnEarlierEpochAndLeavesItsJobsToTheHolder) {
  Ledger restarted(LedgerOptions{}, now, true, std::uint64_t{2} << 32);
  restarted.add_sweep(sweep, JobRanges(2, 8), {});
  auto holder = status(7, 1);
  holder.leases = {{database, 1, (std::uint64_t{1} << 32) + 5, sweep, {{1, 4}}}};
  const auto reaction = restarted.heartbeat(holder, database, now);
  EXPECT_EQ(reaction.adopted_jobs, 3U);
  EXPECT_EQ(restarted.leased(sweep), 3U);
  EXPECT_EQ(restarted.pending(sweep), 5U);
}

TEST_F(LedgerTest, LeasesOfAnotherDatabaseAreNotTouched) {
  ledger.add_sweep(sweep, JobRanges(0, 10), {});
  auto holder = status(7, 1);
  holder.leases = {{Id128{9, 9}, 1, 5, sweep, {{1, 4}}}};
  const auto reaction = ledger.heartbeat(holder, database, now);
  EXPECT_EQ(reaction.adopted_jobs, 0U);
  ASSERT_EQ(reaction.send.size(), 1U);
  EXPECT_EQ(reaction.send[0].kind, messaging::LeaseKind::welcome);
}

TEST_F(LedgerTest, SilentWorkerLosesItsLeasesWhichAreSplit) {
  ledger.add_sweep(sweep, JobRanges(0, 1'000), {});
  beat(7, 1, 1);
  auto grants = ledger.grant(now);
  ledger.ended(sweep, 0, grants[0].lease.lease, 0.01);
  grants = ledger.grant(now);
  ASSERT_EQ(grants.size(), 1U);
  const auto jobs = grants[0].lease.ranges[0].count;
  EXPECT_EQ(jobs, 100U);
  EXPECT_TRUE(ledger.expire(now + std::chrono::seconds{4}).leases.empty());
  const auto expired = ledger.expire(now + std::chrono::seconds{6});
  ASSERT_EQ(expired.leases.size(), 1U);
  EXPECT_EQ(expired.workers, (std::vector<std::uint64_t>{7}));
  EXPECT_EQ(ledger.pending(sweep), 999U);
  EXPECT_EQ(ledger.leased(sweep), 0U);
  EXPECT_TRUE(ledger.is_open(sweep, 1)) << "a part of a lost lease is still wanted";
}

TEST_F(LedgerTest, AnAttemptCountsOnlyForAJobLeasedAloneAndReportedRunning) {
  ledger.add_sweep(sweep, JobRanges(0, 1), {});
  // Never reported running: nobody knows whether it is the job's doing.
  for (std::uint64_t worker = 1; worker <= 5; ++worker) {
    beat(worker, 1, 1);
    ASSERT_EQ(ledger.grant(now).size(), 1U);
    now += std::chrono::seconds{6};
    const auto expired = ledger.expire(now);
    ASSERT_EQ(expired.leases.size(), 1U);
    EXPECT_TRUE(expired.attempts.empty());
    EXPECT_TRUE(expired.quarantined.empty());
  }
  // Twice by chance, and then it is on trial: with workers that hold nothing else.
  for (std::uint32_t loss = 1; loss <= 5; ++loss) {
    grant_and_run(100 + loss);
    now += std::chrono::seconds{6};
    const auto expired = ledger.expire(now);
    ASSERT_EQ(expired.attempts.size(), 1U);
    EXPECT_EQ(expired.attempts[0].counted, loss > 2);
    EXPECT_EQ(ledger.attempts(sweep, 0), loss > 2 ? loss - 2 : 0);
    EXPECT_EQ(expired.quarantined.size(), loss == 5 ? 1U : 0U);
  }
}

TEST_F(LedgerTest, ASweepsPolicyMayAllowOneAttemptOnly) {
  ledger.add_sweep(sweep, JobRanges(0, 1), {.attempts = 1, .needs = {}});
  for (std::uint32_t loss = 1; loss <= 3; ++loss) {
    grant_and_run(100 + loss);
    now += std::chrono::seconds{6};
    EXPECT_EQ(ledger.expire(now).quarantined.size(), loss == 3 ? 1U : 0U);
  }
}

TEST_F(LedgerTest, JobsThatWereLostOnceAreLeasedAsBefore) {
  ledger.add_sweep(sweep, JobRanges(0, 3), {});
  beat(1, 1, 3);
  ASSERT_EQ(ledger.grant(now).size(), 3U);
  now += std::chrono::seconds{6};
  EXPECT_EQ(ledger.expire(now).leases.size(), 3U);
  beat(2, 1, 3);
  EXPECT_EQ(ledger.grant(now).size(), 3U) << "a machine that reboots must not make its jobs wait for each other";
}

TEST_F(LedgerTest, SuspectIsGivenToAWorkerThatHoldsNothingElseAndGetsNothingElse) {
  ledger.add_sweep(sweep, JobRanges(0, 3), {});
  for (std::uint64_t worker = 1; worker <= 2; ++worker) {
    beat(worker, 1, 3);
    ASSERT_EQ(ledger.grant(now).size(), 3U);
    auto running = status(worker, 2, 3);
    running.running = {{sweep, 0}, {sweep, 1}, {sweep, 2}};
    ledger.heartbeat(running, database, now);
    now += std::chrono::seconds{6};
    EXPECT_EQ(ledger.expire(now).leases.size(), 3U);
  }
  beat(3, 1, 3);
  const auto grants = ledger.grant(now);
  ASSERT_EQ(grants.size(), 1U) << "one suspect, alone, although there is room for three";
  EXPECT_TRUE(ledger.grant(now).empty());
  ledger.ended(sweep, grants[0].lease.ranges[0].first, grants[0].lease.lease, 0.1);
  EXPECT_EQ(ledger.grant(now).size(), 1U) << "the next one when that has ended";
}

TEST_F(LedgerTest, JobsThatWereLostBesideTheCulpritAreNotBlamed) {
  ledger.add_sweep(sweep, JobRanges(0, 8), {});
  beat(1, 1, 8);
  ASSERT_EQ(ledger.grant(now).size(), 8U);
  auto running = status(1, 2, 8);
  for (std::uint64_t job = 0; job < 8; ++job) running.running.push_back({sweep, job});
  ledger.heartbeat(running, database, now);
  now += std::chrono::seconds{6};
  EXPECT_EQ(ledger.expire(now).leases.size(), 8U);
  for (std::uint64_t job = 0; job < 8; ++job) EXPECT_EQ(ledger.attempts(sweep, job), 0U);
}

TEST_F(LedgerTest, AWorkerThatWasThoughtDeadTakesItsAttemptBack) {
  ledger.add_sweep(sweep, JobRanges(0, 1), {});
  ledger.restore_attempts(sweep, 0, {});
  const auto lease = grant_and_run(2);
  now += std::chrono::seconds{6};
  ledger.expire(now);
  EXPECT_EQ(ledger.attempts(sweep, 0), 1U);
  auto back = status(2, 9, 1);
  back.leases = {{database, 1, lease, sweep, {{0, 1}}}};
  EXPECT_EQ(ledger.heartbeat(back, database, now).adopted_jobs, 1U);
  EXPECT_EQ(ledger.attempts(sweep, 0), 0U);
}

TEST_F(LedgerTest, APauseOfThisProgramIsNobodysSilence) {
  ledger.add_sweep(sweep, JobRanges(0, 4), {});
  beat(1, 1, 1);
  ASSERT_EQ(ledger.grant(now).size(), 1U);
  now += std::chrono::seconds{60};
  ledger.forgive(std::chrono::seconds{60});
  EXPECT_TRUE(ledger.expire(now).workers.empty());
  EXPECT_TRUE(ledger.expire(now).leases.empty());
}

TEST_F(LedgerTest, SuspectsOfOneSweepDoNotStopAnother) {
  constexpr Id128 other{5, 6};
  ledger.add_sweep(sweep, JobRanges(0, 1), {});
  beat(1, 1, 1);
  ledger.grant(now);
  now += std::chrono::seconds{6};
  ledger.expire(now);
  ledger.add_sweep(other, JobRanges(0, 5), {});
  beat(2, 1, 1);
  const auto grants = ledger.grant(now);
  ASSERT_EQ(grants.size(), 1U);
  EXPECT_EQ(grants[0].lease.sweep, other);
}

TEST_F(LedgerTest, NoWindowIsBelievedBeyondItsBound) {
  ledger.add_sweep(sweep, JobRanges(0, 100'000), {});
  beat(1, 1, ~std::uint32_t{0});
  EXPECT_EQ(ledger.grant(now).size(), 512U);
}

TEST_F(LedgerTest, AWorkerWhoseResultsAreRefusedAgainAndAgainGetsNoMore) {
  ledger.add_sweep(sweep, JobRanges(0, 100), {});
  beat(1, 1, 1);
  int refused = 0;
  for (auto grants = ledger.grant(now); !grants.empty(); grants = ledger.grant(now)) {
    const auto reaction = ledger.refused(sweep, grants[0].lease.ranges[0].first, 1, "bad memory");
    EXPECT_FALSE(reaction.quarantined.has_value());
    EXPECT_EQ(reaction.farewell.has_value(), ++refused == 10);
  }
  EXPECT_EQ(refused, 10);
  EXPECT_EQ(ledger.pending(sweep), 100U) << "its jobs are left to others";
}

TEST_F(LedgerTest, AWorkerThatDoesNotTakeASweepsLeasesIsLeftAloneWithItForAWhile) {
  ledger.add_sweep(sweep, JobRanges(0, 10), {});
  beat(1, 1, 1);
  const auto grants = ledger.grant(now);
  ASSERT_EQ(grants.size(), 1U);
  for (std::uint64_t heartbeat = 2; heartbeat < 12; ++heartbeat) {
    now += std::chrono::milliseconds{500};
    auto refusing = status(1, heartbeat, 1);
    refusing.last_lease_sequence = grants[0].lease.sequence;
    ledger.heartbeat(refusing, database, now);
  }
  EXPECT_EQ(ledger.leased(sweep), 0U);
  EXPECT_TRUE(ledger.grant(now).empty());
  beat(2, 1, 1);
  EXPECT_EQ(ledger.grant(now).size(), 1U) << "others get it";
  now += std::chrono::seconds{31};
  beat(1, 12, 1);
  EXPECT_EQ(ledger.grant(now).size(), 1U);
}

TEST_F(LedgerTest, AWorkerThatHasNotReceivedItsLeaseIsGivenAnother) {
  ledger.add_sweep(sweep, JobRanges(0, 10), {});
  beat(1, 1, 1);
  ASSERT_EQ(ledger.grant(now).size(), 1U);
  for (std::uint64_t heartbeat = 2; heartbeat < 12; ++heartbeat) {
    now += std::chrono::milliseconds{500};
    beat(1, heartbeat, 1);
  }
  EXPECT_EQ(ledger.leased(sweep), 0U) << "others may have its jobs";
  const auto grants = ledger.grant(now);
  ASSERT_EQ(grants.size(), 1U);
  // Numbers grow, also for a worker that was thought dead meanwhile: what it has received is told from what it has not.
  auto taking = status(1, 12, 1);
  taking.last_lease_sequence = grants[0].lease.sequence;
  taking.leases = {{database, 1, grants[0].lease.lease, sweep, {{0, 1}}}};
  EXPECT_TRUE(ledger.heartbeat(taking, database, now).send.empty());
}

TEST_F(LedgerTest, OldHeartbeatsAreIgnored) {
  ledger.add_sweep(sweep, JobRanges(0, 10), {});
  beat(7, 5);
  now += std::chrono::seconds{4};
  beat(7, 4);
  now += std::chrono::seconds{2};
  EXPECT_EQ(ledger.expire(now).workers.size(), 1U) << "the old heartbeat did not keep it alive";
}

TEST_F(LedgerTest, ClosedSweepRevokesItsLeasesAndReturnsItsOpenJobs) {
  ledger.add_sweep(sweep, JobRanges(0, 10), {});
  beat(7, 1, 2);
  ASSERT_EQ(ledger.grant(now).size(), 2U);
  const auto closed = ledger.close_sweep(sweep);
  EXPECT_EQ(closed.open_jobs.size(), 10U);
  EXPECT_EQ(closed.revocations.size(), 2U);
  EXPECT_FALSE(ledger.is_open(sweep, 3));
  EXPECT_TRUE(ledger.grant(now).empty());
}

TEST_F(LedgerTest, HostileRangesOfALeaseDoNoHarm) {
  Ledger restarted(LedgerOptions{}, now, true, std::uint64_t{2} << 32);
  restarted.add_sweep(sweep, JobRanges(0, 10), {});
  auto holder = status(7, 1);
  holder.leases = {{database, 1, 5, sweep, {{~std::uint64_t{0}, 2}, {5, ~std::uint64_t{0}}, {0, 0}, {8, 100}}}};
  const auto reaction = restarted.heartbeat(holder, database, now);
  EXPECT_EQ(reaction.adopted_jobs, 2U);
  EXPECT_EQ(restarted.pending(sweep), 8U);
}

// ---- how sweeps share ----

class SharedLedger : public LedgerTest {
 protected:
  static constexpr Id128 other{5, 6};
  std::map<Id128, std::uint64_t> leases_by_sweep(std::uint32_t window) {
    beat(1, ++heartbeats_, window);
    std::map<Id128, std::uint64_t> leases;
    for (const auto& grant : ledger.grant(now)) ++leases[grant.lease.sweep];
    return leases;
  }

 private:
  std::uint64_t heartbeats_ = 0;
};

TEST_F(SharedLedger, SweepsOfOnePriorityShareTheWorkers) {
  ledger.add_sweep(sweep, JobRanges(0, 100), {});
  ledger.add_sweep(other, JobRanges(0, 100), {});
  EXPECT_EQ(leases_by_sweep(8), (std::map<Id128, std::uint64_t>{{sweep, 4}, {other, 4}}));
}

TEST_F(SharedLedger, AHigherPriorityGoesFirstAndTheRestGetsWhatIsLeft) {
  ledger.add_sweep(sweep, JobRanges(0, 100), {});
  ledger.add_sweep(other, JobRanges(0, 6), {.priority = 1, .needs = {}});
  EXPECT_EQ(leases_by_sweep(8), (std::map<Id128, std::uint64_t>{{sweep, 2}, {other, 6}}));
}

TEST_F(SharedLedger, NoMoreJobsThanTheCapAreLeasedAtOnceAlsoOfLostLeases) {
  ledger.add_sweep(sweep, JobRanges(0, 100), {.max_concurrent = 3, .needs = {}});
  EXPECT_EQ(leases_by_sweep(8).at(sweep), 3U);
  now += std::chrono::seconds{6};
  ledger.expire(now);
  ledger.set_policy(sweep, {.max_concurrent = 2, .needs = {}});
  beat(9, 1, 8);
  EXPECT_EQ(ledger.grant(now).size(), 2U);
  EXPECT_EQ(ledger.leased(sweep), 2U);
}

TEST_F(SharedLedger, OnlyWorkersWithTheNeededLabelsGetTheSweep) {
  ledger.add_sweep(sweep, JobRanges(0, 10), {.needs = {"gpu", "site:attic"}});
  beat(1, 1);
  auto labelled = status(2, 1);
  labelled.labels = {"gpu", "other"};
  ledger.heartbeat(labelled, database, now);
  EXPECT_TRUE(ledger.grant(now).empty());
  labelled = status(3, 1);
  labelled.labels = {"site:attic", "gpu"};
  ledger.heartbeat(labelled, database, now);
  const auto grants = ledger.grant(now);
  ASSERT_EQ(grants.size(), 2U);
  EXPECT_EQ(grants[0].worker, 3U);
}

TEST_F(SharedLedger, SweepsOnARobotGoToWhoHoldsItsClaimAndOthersToOthers) {
  ledger.add_sweep(sweep, JobRanges(0, 10), {.needs = {}, .needs_robot = true});
  ledger.add_sweep(other, JobRanges(0, 10), {});
  auto holder = status(2, 1);
  holder.labels = {"bridge=bench", "bridge"};
  ledger.heartbeat(holder, database, now);
  auto waiting = status(3, 1);
  waiting.labels = {"bridge=bench"};
  ledger.heartbeat(waiting, database, now);
  beat(1, 1);
  const auto grants = ledger.grant(now);
  EXPECT_FALSE(grants.empty());
  for (const auto& grant : grants) {
    EXPECT_NE(grant.worker, 3U) << "without the claim it could do neither";
    EXPECT_EQ(grant.lease.sweep, grant.worker == 2U ? sweep : other);
  }
}

TEST_F(SharedLedger, PausedSweepsKeepTheirJobsAndRevokeTheirLeases) {
  ledger.add_sweep(sweep, JobRanges(0, 10), {});
  EXPECT_EQ(leases_by_sweep(4).at(sweep), 4U);
  const auto revocations = ledger.pause(sweep);
  ASSERT_EQ(revocations.size(), 4U);
  EXPECT_TRUE(revocations[0].interrupt);
  EXPECT_EQ(revocations[0].origin.worker, 1U);
  EXPECT_EQ(ledger.pending(sweep), 10U);
  EXPECT_EQ(ledger.leased(sweep), 0U);
  EXPECT_TRUE(leases_by_sweep(4).empty());
  EXPECT_TRUE(ledger.is_open(sweep, 0)) << "what had been computed still counts";
  ledger.resume(sweep);
  EXPECT_EQ(leases_by_sweep(4).at(sweep), 4U);
}

TEST_F(SharedLedger, ADrainingWorkerGetsNothingMoreAndIsToldAgainUntilItLeaves) {
  ledger.add_sweep(sweep, JobRanges(0, 10), {});
  beat(1, 1);
  ASSERT_TRUE(ledger.drain(1).has_value());
  EXPECT_FALSE(ledger.drain(2).has_value());
  EXPECT_TRUE(ledger.grant(now).empty());
  const auto reaction = ledger.heartbeat(status(1, 2), database, now);
  ASSERT_EQ(reaction.send.size(), 1U);
  EXPECT_EQ(reaction.send[0].kind, messaging::LeaseKind::drain);
}

TEST_F(SharedLedger, DrainingLastsOverARestart) {
  ledger.remember_draining({1});
  ledger.add_sweep(sweep, JobRanges(0, 10), {});
  const auto reaction = ledger.heartbeat(status(1, 1), database, now);
  EXPECT_EQ(reaction.send.front().kind, messaging::LeaseKind::drain);
  EXPECT_TRUE(ledger.grant(now).empty());
}

TEST_F(SharedLedger, AJobWithACheckpointIsLeasedAloneAndFirst) {
  ledger.add_sweep(sweep, JobRanges(0, 1'000), {});
  beat(1, 1, 1);
  auto grants = ledger.grant(now);
  ledger.ended(sweep, 0, grants.at(0).lease.lease, 1e-6);
  ledger.note_checkpoint(sweep, 700);
  grants = ledger.grant(now);
  ASSERT_EQ(grants.size(), 1U);
  EXPECT_EQ(grants[0].lease.ranges, (std::vector<messaging::JobRange>{{700, 1}}));
  ledger.ended(sweep, 700, grants[0].lease.lease, 1e-6);
  EXPECT_FALSE(ledger.has_checkpoint(sweep, 700));
}

TEST_F(SharedLedger, JobsWithCheckpointsAreCutOutOfALostLease) {
  ledger.add_sweep(sweep, JobRanges(0, 1'000), {});
  beat(1, 1, 1);
  auto grants = ledger.grant(now);
  ledger.ended(sweep, 0, grants.at(0).lease.lease, 1e-6);
  grants = ledger.grant(now);
  const auto range = grants.at(0).lease.ranges.at(0);
  ASSERT_GT(range.count, 10U);
  ledger.note_checkpoint(sweep, range.first + 5);
  now += std::chrono::seconds{6};
  ledger.expire(now);
  EXPECT_EQ(ledger.pending(sweep), 999U);
  bool alone = false;
  beat(2, 1, 512);
  for (const auto& grant : ledger.grant(now)) {
    for (const auto& part : grant.lease.ranges) {
      if (part.first <= range.first + 5 && range.first + 5 < part.first + part.count) alone = part.count == 1;
    }
  }
  EXPECT_TRUE(alone);
}

TEST_F(SharedLedger, AnAuditedJobIsGivenToAnotherWorkerThanItsAuthor) {
  ledger.add_audit(other, {{1, JobRanges(0, 3)}, {2, JobRanges(3, 2)}});
  beat(1, 1, 8);
  for (const auto& grant : ledger.grant(now)) EXPECT_GE(grant.lease.ranges.at(0).first, 3U);
  EXPECT_EQ(ledger.leased(other), 2U);
  EXPECT_EQ(ledger.waiting_for_another_worker(other), 3U);
  beat(2, 1, 8);
  EXPECT_EQ(ledger.waiting_for_another_worker(other), 0U);
  ledger.grant(now);
  EXPECT_EQ(ledger.leased(other), 5U);
}

}  // namespace
}  // namespace lamprey::coordinator
