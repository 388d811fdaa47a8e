// What the coordinator grants, accepts and refuses.
#include "tests/coordinator/hand_worker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

namespace lamprey::tests {
namespace {

using messaging::Verdict;

class ProtocolRules : public testing::Test {
 protected:
  void SetUp() override {
    site.start_coordinator();
    site.submit(yaml);
    leases = hand.heartbeat();
    ASSERT_FALSE(leases.empty());
    origin = leases.back().origin;
    sweep = leases.back().sweep;
  }
  std::vector<messaging::Acknowledgement> send(const messaging::JobResult& result) {
    return hand.send(origin, sweep, result);
  }
  void expect_refused(const messaging::JobResult& result, const std::string& reason) {
    const auto answers = send(result);
    ASSERT_EQ(answers.size(), 1U);
    EXPECT_EQ(answers[0].verdict, Verdict::refused);
    EXPECT_THAT(answers[0].reason, testing::HasSubstr(reason));
    EXPECT_EQ(site.rows(), 0U);
  }

  std::string yaml = small_sweep("rules", 16);
  Site site;
  HandWorker hand{site, 0x77};
  experiment::SweepGrid grid{experiment::parse_sweep(yaml, "test").specification};
  std::vector<messaging::Lease> leases;
  messaging::Origin origin;
  experiment::Id128 sweep;
};

TEST_F(ProtocolRules, WorkerIsWelcomedAndGetsNoMoreLeasesThanItsWindow) {
  ASSERT_EQ(leases.size(), 3U);
  EXPECT_EQ(leases[0].kind, messaging::LeaseKind::welcome);
  EXPECT_EQ(leases[1].kind, messaging::LeaseKind::grant);
  EXPECT_LT(leases[1].lease, leases[2].lease);
  EXPECT_EQ(leases[1].sequence, leases[1].lease);
  EXPECT_EQ(leases[2].sequence, leases[2].lease);
  EXPECT_EQ(leases[1].ranges, (std::vector<messaging::JobRange>{{0, 1}}));
  EXPECT_EQ(leases[2].ranges, (std::vector<messaging::JobRange>{{1, 1}}));
}

TEST_F(ProtocolRules, ResultIsCommittedOnceThenADuplicate) {
  const auto result = computed(grid, 0);
  const auto first = send(result);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].verdict, Verdict::committed);
  EXPECT_EQ(site.rows(), 1U);
  const auto second = send(result);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(second[0].verdict, Verdict::duplicate);
  EXPECT_EQ(site.rows(), 1U);
}

TEST_F(ProtocolRules, ResultOfAJobThatIsNotLeasedCountsToo) {
  EXPECT_EQ(send(computed(grid, 15)).at(0).verdict, Verdict::committed);
}

TEST_F(ProtocolRules, AnotherDigestIsADivergenceAndTheFirstStays) {
  auto result = computed(grid, 0);
  const auto stored = experiment::to_hex(result.digest);
  ASSERT_EQ(send(result).at(0).verdict, Verdict::committed);
  result.outcome.evolved.fuel += 1;
  result.digest = experiment::outcome_digest(result.identity, result.outcome);
  EXPECT_EQ(send(result).at(0).verdict, Verdict::divergent);
  EXPECT_EQ(site.number("SELECT count(*) FROM divergence"), 1U);
  EXPECT_EQ(site.number("SELECT count(*) FROM result WHERE digest = '" + stored + "'"), 1U);
  EXPECT_EQ(site.rows(), 1U);
}

TEST_F(ProtocolRules, DivergenceThatIsNotWhatItClaimsIsRefused) {
  auto result = computed(grid, 0);
  ASSERT_EQ(send(result).at(0).verdict, Verdict::committed);
  result.digest[3] ^= 1;
  EXPECT_EQ(send(result).at(0).verdict, Verdict::refused);
  EXPECT_EQ(site.number("SELECT count(*) FROM divergence"), 0U);
}

TEST_F(ProtocolRules, OutcomeOfAJobThatIsStoredAsFailedIsNotCalledADuplicate) {
  messaging::JobResult failed;
  failed.job = 0;
  failed.kind = messaging::ResultKind::failed;
  failed.identity = experiment::identity(grid.job(0));
  failed.digest[0] = 9;  // a failure has none; whatever is there must not be taken for one
  ASSERT_EQ(send(failed).at(0).verdict, Verdict::committed);
  const auto answers = send(computed(grid, 0));
  EXPECT_EQ(answers.at(0).verdict, Verdict::refused);
  EXPECT_THAT(answers.at(0).reason, testing::HasSubstr("failed"));
  EXPECT_EQ(site.number("SELECT count(*) FROM divergence"), 0U);
}

TEST_F(ProtocolRules, DatabaseThatSomebodyElseWritesIsWaitedFor) {
  sqlite3* other = nullptr;
  ASSERT_EQ(sqlite3_open(site.database().c_str(), &other), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr), SQLITE_OK);
  const auto result = computed(grid, 0);
  EXPECT_TRUE(send(result).empty()) << "not stored, so not acknowledged";
  ASSERT_EQ(sqlite3_exec(other, "ROLLBACK", nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(other);
  site.advance(std::chrono::seconds{2});
  EXPECT_EQ(site.rows(), 1U);
  EXPECT_EQ(send(result).back().verdict, Verdict::duplicate);
}

TEST_F(ProtocolRules, HostNameThatIsNoTextDoesNotSpoilTheStatus) {
  HandWorker odd(site, 0x55);
  odd.host = "caf\xe9\n";
  odd.heartbeat();
  idl::Request request;
  request.mutable_status();
  EXPECT_EQ(site.ask(request).status().workers_size(), 2);
}

TEST_F(ProtocolRules, RequestThatNamesAnotherDatabaseIsNotForThisCoordinator) {
  const auto client = site.bus.join("client");
  const auto replies =
      client->reader<messaging::Reply>(std::make_shared<messaging::Signal>(), messaging::Partition::of(0xc1));
  const auto requests = client->writer<messaging::Request>();
  idl::Request request;
  request.mutable_status();
  const auto bytes = request.SerializeAsString();
  messaging::Request sample;
  sample.client = 0xc1;
  sample.payload.assign(bytes.begin(), bytes.end());
  sample.origin.database = {1, 1};
  ASSERT_TRUE(static_cast<bool>(requests->write(sample)));
  site.advance(std::chrono::milliseconds{200});
  EXPECT_TRUE(replies->take().empty());
  sample.origin.database = origin.database;
  ASSERT_TRUE(static_cast<bool>(requests->write(sample)));
  site.advance(std::chrono::milliseconds{200});
  EXPECT_EQ(replies->take().size(), 1U);
}

TEST_F(ProtocolRules, ForgedDigestIsRefused) {
  auto result = computed(grid, 0);
  result.digest[5] ^= 1;
  expect_refused(result, "digest");
}

TEST_F(ProtocolRules, OutcomeOfAnotherJobIsRefused) {
  auto result = computed(grid, 0);
  result.job = 1;
  expect_refused(result, "identity");
}

TEST_F(ProtocolRules, JobBeyondTheSweepIsRefused) {
  auto result = computed(grid, 0);
  result.job = 16;
  expect_refused(result, "no such job");
}

TEST_F(ProtocolRules, ValuesThatAreNotNumbersAreRefused) {
  auto result = computed(grid, 0);
  result.outcome.final.total = std::numeric_limits<double>::quiet_NaN();
  result.digest = experiment::outcome_digest(result.identity, result.outcome);
  expect_refused(result, "finite");
}

TEST_F(ProtocolRules, TraceThatDoesNotFitItsCountersIsRefused) {
  auto result = computed(grid, 0);
  result.outcome.accepted += 1;
  result.digest = experiment::outcome_digest(result.identity, result.outcome);
  expect_refused(result, "trace");
}

TEST_F(ProtocolRules, MeasuresArriveWithTheOutcome) {
  auto result = computed(grid, 0);
  result.outcome.measures = {{"recovered", 0, 1}, {"recovery_cycles", 0, 17}};
  result.digest = experiment::outcome_digest(result.identity, result.outcome);
  ASSERT_EQ(send(result).at(0).verdict, Verdict::committed);
  EXPECT_EQ(site.number("SELECT count(*) FROM measure WHERE job = 0"), 2U);
}

TEST_F(ProtocolRules, MeasuresThatNoModelHasAreRefused) {
  const auto expect_measures_refused = [&](const std::vector<experiment::Measure>& measures,
                                           const std::string& reason) {
    auto result = computed(grid, 0);
    result.outcome.measures = measures;
    result.digest = experiment::outcome_digest(result.identity, result.outcome);
    expect_refused(result, reason);
  };
  expect_measures_refused({{"a'); DROP TABLE job; --", 0, 1}}, "name of a measure");
  expect_measures_refused({{"a", 0, std::numeric_limits<double>::infinity()}}, "not a finite number");
  expect_measures_refused({{"a", 1, 1}, {"a", 0, 1}}, "out of order");
  std::vector<experiment::Measure> many;
  for (std::uint32_t index = 0; index < 77; ++index) many.push_back({"a", index, 1});  // 64 and 4 for each of 3 cycles
  expect_measures_refused(many, "77 measures");
}

TEST_F(ProtocolRules, ResultOfAnotherScienceVersionIsRefused) {
  origin.science_version += 1;
  expect_refused(computed(grid, 0), "science version");
}

TEST_F(ProtocolRules, ResultOfAnUnknownSweepIsRefused) {
  sweep.low += 1;
  expect_refused(computed(grid, 0), "no such sweep");
}

TEST_F(ProtocolRules, ResultsForAnotherDatabaseAreNobodysBusiness) {
  origin.database.low += 1;
  EXPECT_TRUE(send(computed(grid, 0)).empty());
  EXPECT_EQ(site.rows(), 0U);
}

TEST_F(ProtocolRules, RefusedResultsOfAStrangerCannotQuarantineAJob) {
  HandWorker stranger(site, 0x99);
  stranger.heartbeat();
  auto forged = computed(grid, 0);
  forged.digest[0] ^= 1;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(stranger.send(origin, sweep, forged).at(0).verdict, Verdict::refused);
  EXPECT_EQ(site.rows(), 0U);
  EXPECT_EQ(send(computed(grid, 0)).at(0).verdict, Verdict::committed);
}

TEST_F(ProtocolRules, FailedJobIsARowWithItsReason) {
  messaging::JobResult failed;
  failed.job = 0;
  failed.kind = messaging::ResultKind::failed;
  failed.identity = experiment::identity(grid.job(0));
  failed.reason = "out of paper";
  EXPECT_EQ(send(failed).at(0).verdict, Verdict::committed);
  EXPECT_EQ(site.rows("state = 'failed' AND reason = 'out of paper'"), 1U);
}

TEST_F(ProtocolRules, LeaseThatWasNeverGrantedIsRevoked) {
  const messaging::HeldLease invented{origin.database, 1, ~std::uint64_t{0}, sweep, {{5, 3}}};
  std::vector<messaging::HeldLease> held{invented};
  for (const auto& lease : leases) {
    if (lease.kind == messaging::LeaseKind::grant)
      held.push_back({origin.database, 1, lease.lease, sweep, lease.ranges});
  }
  const auto answers = hand.heartbeat(held);
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].kind, messaging::LeaseKind::revoke);
  EXPECT_EQ(answers[0].lease, invented.lease);
}

TEST_F(ProtocolRules, WorkerOfAnotherScienceVersionGetsNoLeaseAndIsToldWhy) {
  HandWorker stranger(site, 0x98);
  stranger.science_version += 1;
  const auto answers = stranger.heartbeat();
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].kind, messaging::LeaseKind::refuse);
  EXPECT_THAT(answers[0].reason, testing::HasSubstr("science version 2"));
}

TEST_F(ProtocolRules, CancelledSweepHasARowPerJobAndRefusesLateResults) {
  ASSERT_EQ(send(computed(grid, 0)).at(0).verdict, Verdict::committed);
  idl::Request request;
  request.mutable_cancel()->set_sweep("rules");
  EXPECT_EQ(site.ask(request).cancel().cancelled(), 15U);
  ASSERT_TRUE(site.run_to_end());
  EXPECT_EQ(site.rows("state = 'cancelled'"), 15U);
  EXPECT_EQ(site.rows("state = 'done'"), 1U);
  EXPECT_EQ(site.ask(request).cancel().cancelled(), 15U) << "again: the same answer";
  const auto answers = send(computed(grid, 3));
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].verdict, Verdict::refused);
  EXPECT_EQ(site.number("SELECT count(*) FROM sweep WHERE state = 'cancelled'"), 1U);
}

TEST_F(ProtocolRules, CancellingGoesOnAfterARestart) {
  idl::Request request;
  request.mutable_cancel()->set_sweep("rules");
  site.ask(request);
  site.kill_coordinator();
  site.start_coordinator();
  ASSERT_TRUE(site.run_to_end());
  EXPECT_EQ(site.rows("state = 'cancelled'"), 16U);
}

TEST_F(ProtocolRules, SubmittingTheSameSweepAgainNamesTheSameSweep) {
  idl::Request request;
  *request.mutable_submit()->mutable_specification() = experiment::parse_sweep(yaml, "test").specification;
  const auto reply = site.ask(request);
  ASSERT_TRUE(reply.has_submit());
  EXPECT_TRUE(reply.submit().existed());
  EXPECT_EQ(site.number("SELECT count(*) FROM sweep"), 1U);
}

TEST_F(ProtocolRules, AnotherSweepOfTheSameNameIsRefused) {
  idl::Request request;
  *request.mutable_submit()->mutable_specification() =
      experiment::parse_sweep(small_sweep("rules", 20), "test").specification;
  const auto reply = site.ask(request);
  ASSERT_TRUE(reply.has_error());
  EXPECT_EQ(reply.error().code(), "sweep_changed");
}

TEST_F(ProtocolRules, InvalidSpecificationIsRefusedByTheCoordinatorToo) {
  idl::Request request;
  auto* specification = request.mutable_submit()->mutable_specification();
  *specification = experiment::parse_sweep(small_sweep("bad"), "test").specification;
  specification->mutable_base(0)->set_parameter("cylces");
  const auto reply = site.ask(request);
  ASSERT_TRUE(reply.has_error());
  EXPECT_EQ(reply.error().code(), "invalid_specification");
  EXPECT_THAT(reply.error().messages(0), testing::HasSubstr("cycles"));
  EXPECT_EQ(site.number("SELECT count(*) FROM sweep"), 1U);
}

TEST_F(ProtocolRules, UnknownSweepIsAnsweredWithTheNearestName) {
  idl::Request request;
  request.mutable_cancel()->set_sweep("ruels");
  const auto reply = site.ask(request);
  ASSERT_TRUE(reply.has_error());
  EXPECT_EQ(reply.error().code(), "unknown_sweep");
  EXPECT_THAT(reply.error().messages(0), testing::HasSubstr("'rules'"));
}

TEST_F(ProtocolRules, ResultsArePagedInOrderOfJob) {
  site.start_worker();
  ASSERT_TRUE(site.run_to_end());
  std::vector<std::string> digests;
  std::uint64_t next = 0;
  for (bool more = true; more;) {
    idl::Request request;
    request.mutable_results()->set_sweep("rules");
    request.mutable_results()->set_first_job(next);
    request.mutable_results()->set_limit(5);
    const auto reply = site.ask(request);
    ASSERT_TRUE(reply.has_results());
    for (const auto& row : reply.results().rows()) digests.push_back(row.values(3));
    more = reply.results().has_next_job();
    next = reply.results().next_job();
  }
  EXPECT_EQ(digests.size(), 16U);
}

}  // namespace
}  // namespace lamprey::tests
