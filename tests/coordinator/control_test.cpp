// Steering sweeps, against a real coordinator, real workers' protocol and a real database.
#include "storage/results_reader.hpp"
#include "tests/coordinator/site.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::tests {
namespace {

using ::testing::HasSubstr;

class Control : public testing::Test {
 protected:
  Site site;

  void SetUp() override {
    site.jobs_per_step = 1;
    site.start_coordinator();
  }

  idl::Reply wish(idl::ControlRequest::Action action, const std::string& sweep = "s", bool cancelled_too = false) {
    idl::Request request;
    request.mutable_control()->set_sweep(sweep);
    request.mutable_control()->set_action(action);
    request.mutable_control()->set_cancelled_too(cancelled_too);
    return site.ask(request);
  }
  std::string state(const std::string& sweep = "s") {
    const auto stored = storage::ResultsReader(site.database().string()).find_sweep(sweep);
    return stored ? to_text(stored->state) : "none";
  }
  void restart() {
    site.kill_coordinator();
    site.start_coordinator();
  }
  std::uint64_t events(const std::string& kind) {
    return site.number("SELECT count(*) FROM event WHERE kind = '" + kind + "'");
  }
  idl::SweepStatus status(const std::string& sweep = "s") {
    idl::Request request;
    request.mutable_status()->set_sweep(sweep);
    return site.ask(request).status().sweeps(0);
  }
  std::string metrics() {
    idl::Request request;
    request.mutable_metrics();
    return site.ask(request).metrics().text();
  }
  /// A sweep of 96 jobs of which some have ended.
  void run_some(const std::string& extra = "") {
    site.submit(small_sweep("s") + extra);
    site.start_worker();
    ASSERT_TRUE(site.run_until([&] { return site.rows() >= 10; }));
    ASSERT_FALSE(site.ended());
  }
};

TEST_F(Control, PausedSweepStandsStillAndGoesOnToTheSameEnd) {
  run_some();
  EXPECT_EQ(wish(idl::ControlRequest::PAUSE).control().state(), "paused");
  site.advance(std::chrono::seconds{2});
  const auto rows = site.rows();
  site.advance(std::chrono::seconds{10});
  EXPECT_EQ(site.rows(), rows);
  EXPECT_EQ(wish(idl::ControlRequest::PAUSE).control().state(), "paused") << "twice is as good as once";
  EXPECT_EQ(status().state(), "paused");
  EXPECT_EQ(wish(idl::ControlRequest::RESUME).control().state(), "running");
  EXPECT_EQ(wish(idl::ControlRequest::RESUME).control().state(), "running");
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(events("sweep_paused"), 1U);
  EXPECT_EQ(events("sweep_resumed"), 1U);
}

TEST_F(Control, PauseLastsOverARestart) {
  run_some();
  wish(idl::ControlRequest::PAUSE);
  site.advance(std::chrono::seconds{1});
  restart();
  site.advance(std::chrono::seconds{3});
  const auto rows = site.rows();
  site.advance(std::chrono::seconds{10});
  EXPECT_EQ(site.rows(), rows);
  EXPECT_EQ(state(), "paused");
  wish(idl::ControlRequest::RESUME);
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
}

TEST_F(Control, ResumeWithAnotherFileIsRefusedWithTheDifference) {
  run_some();
  wish(idl::ControlRequest::PAUSE);
  idl::Request request;
  request.mutable_control()->set_sweep("s");
  request.mutable_control()->set_action(idl::ControlRequest::RESUME);
  *request.mutable_control()->mutable_specification() =
      experiment::parse_sweep(
          "name: s\nseed: 8\nbase: {cycles: 3, mutation: all}\ngrids:\n  - {required_stability: "
          "[25, 50, 75, 100]}\nreplicates: 24\n",
          "other.yaml")
          .specification;
  const auto reply = site.ask(request);
  EXPECT_EQ(reply.error().code(), "sweep_changed");
  EXPECT_THAT(reply.error().messages(0), HasSubstr("seed: 7, now 8"));
  EXPECT_EQ(state(), "paused");
}

TEST_F(Control, SubmittingAChangedFileUnderTheSameNameIsRefusedWithTheDifference) {
  site.submit(small_sweep("s"));
  idl::Request request;
  *request.mutable_submit()->mutable_specification() =
      experiment::parse_sweep(small_sweep("s", 8), "s.yaml").specification;
  const auto reply = site.ask(request);
  EXPECT_EQ(reply.error().code(), "sweep_changed");
  EXPECT_THAT(reply.error().messages(0), HasSubstr("replicates: 24, now 2"));
}

TEST_F(Control, FailFastEndsTheSweepWithItsFirstFailure) {
  site.submit(small_sweep("s") + "fail_fast: true\n");
  auto& worker = site.start_worker();
  worker.executor->fails = [](const worker::Task& task) { return task.job == 5; };
  ASSERT_TRUE(site.run_to_end());
  EXPECT_EQ(state(), "cancelled");
  EXPECT_EQ(site.rows("state = 'failed'"), 1U);
  EXPECT_GT(site.rows("state = 'cancelled'"), 50U);
  EXPECT_EQ(site.rows(), 96U);
  EXPECT_THAT(status().reason(), HasSubstr("fail fast"));
  EXPECT_EQ(events("sweep_stopped"), 1U);
}

TEST_F(Control, ASweepStopsWhenAnOutcomeIsGoodEnough) {
  site.submit(small_sweep("s") + "stop_when: {expected_total: 1}\n");
  site.start_worker();
  ASSERT_TRUE(site.run_to_end());
  EXPECT_EQ(state(), "cancelled");
  EXPECT_GE(site.rows("state = 'done'"), 1U);
  EXPECT_GT(site.rows("state = 'cancelled'"), 50U);
  EXPECT_THAT(status().reason(), HasSubstr("expected_total is "));
}

TEST_F(Control, ASweepStopsAfterSoManyJobs) {
  site.submit(small_sweep("s") + "stop_when: {done: 20}\n");
  site.start_worker();
  ASSERT_TRUE(site.run_to_end());
  EXPECT_EQ(state(), "cancelled");
  EXPECT_GE(site.rows("state = 'done'"), 20U);
  EXPECT_LT(site.rows("state = 'done'"), 40U);
}

TEST_F(Control, FailedJobsAreTriedAgainAndTheirFirstEndIsKept) {
  site.submit(small_sweep("s"));
  auto& worker = site.start_worker();
  worker.executor->fails = [](const worker::Task& task) { return task.job % 10 == 0; };
  ASSERT_TRUE(site.run_to_end());
  EXPECT_EQ(site.rows("state = 'failed'"), 10U);
  worker.executor->fails = nullptr;
  const auto reply = wish(idl::ControlRequest::RETRY);
  EXPECT_EQ(reply.control().jobs(), 10U);
  EXPECT_EQ(reply.control().state(), "running");
  EXPECT_EQ(wish(idl::ControlRequest::RETRY).control().jobs(), 0U) << "twice is as good as once";
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(site.number("SELECT count(*) FROM attempt WHERE ending = 'failed'"), 10U);
}

TEST_F(Control, RetryOfARunningSweepIsRightAway) {
  site.submit(small_sweep("s"));
  auto& worker = site.start_worker();
  worker.executor->fails = [](const worker::Task& task) { return task.job == 0; };
  ASSERT_TRUE(site.run_until([&] { return site.rows("state = 'failed'") == 1; }));
  worker.executor->fails = nullptr;
  EXPECT_EQ(wish(idl::ControlRequest::RETRY).control().jobs(), 1U);
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
}

TEST_F(Control, CancelledJobsComeBackOnlyWhenWished) {
  run_some();
  idl::Request request;
  request.mutable_cancel()->set_sweep("s");
  site.ask(request);
  ASSERT_TRUE(site.run_to_end());
  EXPECT_EQ(wish(idl::ControlRequest::RETRY).control().jobs(), 0U);
  EXPECT_EQ(state(), "cancelled");
  EXPECT_GT(wish(idl::ControlRequest::RETRY, "s", true).control().jobs(), 0U);
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
}

TEST_F(Control, ArchivedSweepsStayAndSayIt) {
  site.submit(small_sweep("s", 8));
  EXPECT_EQ(wish(idl::ControlRequest::ARCHIVE).error().code(), "not_possible");
  site.start_worker();
  ASSERT_TRUE(site.run_to_end());
  EXPECT_TRUE(wish(idl::ControlRequest::ARCHIVE).has_control());
  restart();
  EXPECT_TRUE(status().archived());
  EXPECT_TRUE(wish(idl::ControlRequest::UNARCHIVE).has_control());
  EXPECT_FALSE(status().archived());
  EXPECT_EQ(site.rows(), 8U);
}

TEST_F(Control, DeletedSweepsAreGoneAlsoWhenTheCoordinatorDiesMeanwhile) {
  run_some();
  EXPECT_EQ(wish(idl::ControlRequest::DELETE).error().code(), "not_possible") << "it runs";
  ASSERT_TRUE(site.run_to_end());
  EXPECT_TRUE(wish(idl::ControlRequest::DELETE).has_control());
  restart();
  ASSERT_TRUE(site.run_until([&] { return state() == "none"; }));
  EXPECT_EQ(site.rows(), 0U);
  EXPECT_EQ(wish(idl::ControlRequest::DELETE).error().code(), "unknown_sweep");
}

TEST_F(Control, RenamedSweepsKeepTheirIdAndGoOn) {
  run_some();
  const auto id = status().id();
  idl::Request request;
  request.mutable_rename()->set_sweep("s");
  request.mutable_rename()->set_name("better");
  EXPECT_TRUE(site.ask(request).has_control());
  EXPECT_TRUE(site.ask(request).has_control()) << "twice is as good as once";
  EXPECT_EQ(status("better").id(), id);
  request.mutable_rename()->set_sweep("better");
  request.mutable_rename()->set_name("no such/name");
  EXPECT_EQ(site.ask(request).error().code(), "not_possible");
  ASSERT_TRUE(site.run_to_end());
  EXPECT_EQ(state("better"), "finished");
}

TEST_F(Control, PriorityIsChangedWhileSweepsRun) {
  site.submit(small_sweep("s"));
  site.submit(small_sweep("t"));
  idl::Request request;
  request.mutable_adjust()->set_sweep("t");
  request.mutable_adjust()->set_priority(5);
  EXPECT_TRUE(site.ask(request).has_control());
  restart();
  site.start_worker();
  ASSERT_TRUE(site.run_until([&] { return state("t") == "finished"; }));
  EXPECT_EQ(status("s").counts().done(), 0U) << "the other one had to wait";
  EXPECT_EQ(status("t").execution().priority(), 5);
  request.mutable_adjust()->set_priority(100'000);
  EXPECT_EQ(site.ask(request).error().code(), "not_possible");
}

TEST_F(Control, ADrainedWorkerFinishesWhatItHoldsAndLeaves) {
  run_some();
  idl::Request request;
  request.mutable_drain()->set_worker("host");
  const auto reply = site.ask(request);
  ASSERT_EQ(reply.drain().workers_size(), 1);
  ASSERT_TRUE(site.run_until([&] { return site.worker(0).worker->drained(); }));
  const auto rows = site.rows();
  site.advance(std::chrono::seconds{3});
  EXPECT_EQ(site.rows(), rows);
  request.mutable_drain()->set_worker("hos");
  EXPECT_THAT(site.ask(request).error().messages(0), HasSubstr("did you mean 'host'?"));
  site.start_worker();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
}

TEST_F(Control, MetricsCountWhatHappened) {
  run_some();
  ASSERT_TRUE(site.run_to_end());
  const auto page = metrics();
  EXPECT_THAT(page, HasSubstr("lamprey_results_total{verdict=\"committed\"} 96"));
  EXPECT_THAT(page, HasSubstr("# TYPE lamprey_lease_events_total counter"));
  EXPECT_THAT(page, HasSubstr("lamprey_workers{state=\"ready\"} 1"));
  EXPECT_THAT(page, HasSubstr("lamprey_storage_healthy 1"));
  EXPECT_THAT(page, HasSubstr("lamprey_requests_total{kind=\"submit\"} 1"));
}

TEST_F(Control, EventsTellTheStoryInOrder) {
  run_some();
  ASSERT_TRUE(site.run_to_end());
  site.advance(std::chrono::seconds{1});
  idl::Request request;
  request.mutable_events()->set_sweep("s");
  const auto reply = site.ask(request);
  std::vector<std::string> kinds;
  for (const auto& event : reply.events().events()) kinds.push_back(event.kind());
  EXPECT_THAT(kinds, ::testing::ElementsAre("sweep_submitted", "sweep_finished"));
  request.mutable_events()->set_after(reply.events().events(0).event());
  EXPECT_EQ(site.ask(request).events().events_size(), 1);
}

TEST_F(Control, EveryRowNamesWhereItComesFrom) {
  site.submit(small_sweep("s", 8));
  site.start_worker();
  ASSERT_TRUE(site.run_to_end());
  EXPECT_EQ(site.number("SELECT count(*) FROM provenance WHERE host = 'host' AND build = 'test' AND dds = 'in_memory' "
                        "AND processor = 'a processor' AND queue_seconds >= 0 AND commit_seconds >= 0 AND attempt = 1"),
            8U);
}

// ---- outcomes that exist ----

TEST_F(Control, OutcomesThatExistAreNotComputedAgain) {
  site.submit(small_sweep("s"));
  site.start_worker();
  ASSERT_TRUE(site.run_to_end());
  const auto computed = site.computed();
  // The same cells and more of them, under another name.
  site.submit(small_sweep("t", 104));
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(site.computed(), computed + 8);
  EXPECT_EQ(status("t").reused(), 96U);
}

TEST_F(Control, FreshSweepsAreComputedAgain) {
  site.submit(small_sweep("s"));
  site.start_worker();
  ASSERT_TRUE(site.run_to_end());
  const auto computed = site.computed();
  idl::Request request;
  *request.mutable_submit()->mutable_specification() =
      experiment::parse_sweep(small_sweep("t"), "t.yaml").specification;
  request.mutable_submit()->set_fresh(true);
  ASSERT_TRUE(site.ask(request).has_submit());
  ASSERT_TRUE(site.run_to_end());
  EXPECT_EQ(site.computed(), computed + 96);
  EXPECT_EQ(status("t").reused(), 0U);
}

TEST_F(Control, ADamagedOutcomeIsNotReused) {
  site.submit(small_sweep("s", 8));
  site.start_worker();
  ASSERT_TRUE(site.run_to_end());
  site.kill_coordinator();
  site.write("UPDATE job SET final_total = final_total + 1 WHERE job = 3");
  site.start_coordinator();
  site.submit(small_sweep("t", 8));
  ASSERT_TRUE(site.run_to_end());
  EXPECT_EQ(status("t").reused(), 7U);
  EXPECT_EQ(site.number("SELECT count(*) FROM job AS a JOIN job AS b USING (job) WHERE a.sweep < b.sweep AND a.digest "
                        "= b.digest AND a.final_total <> b.final_total"),
            1U);
}

// ---- audits ----

class Audit : public Control {
 protected:
  idl::AuditStatus audit(double share) {
    idl::Request request;
    request.mutable_audit()->set_sweep("s");
    request.mutable_audit()->set_share(share);
    const auto reply = site.ask(request);
    EXPECT_TRUE(reply.has_audit()) << reply.DebugString();
    return reply.audit();
  }
  idl::AuditStatus look(const std::string& id) {
    idl::Request request;
    request.mutable_audit_status()->set_audit(id);
    return site.ask(request).audit();
  }
};

TEST_F(Audit, OtherWorkersComputeAShareAgainAndAgree) {
  site.submit(small_sweep("s"));
  site.start_worker();
  ASSERT_TRUE(site.run_to_end());
  const auto begun = audit(0.5);
  EXPECT_GT(begun.jobs(), 30U);
  EXPECT_LT(begun.jobs(), 66U);
  site.advance(std::chrono::seconds{5});
  EXPECT_EQ(look(begun.audit()).waiting_for_another_worker(), begun.jobs()) << "nobody judges himself";
  EXPECT_EQ(look(begun.audit()).agreed(), 0U);
  site.start_worker();
  ASSERT_TRUE(site.run_until([&] { return look(begun.audit()).state() == "finished"; }));
  EXPECT_EQ(look(begun.audit()).agreed(), begun.jobs());
  EXPECT_EQ(site.rows(), 96U) << "no second row";
  EXPECT_EQ(status().audited(), begun.jobs());
  EXPECT_EQ(audit(0.5).state(), "finished") << "twice is as good as once";
}

TEST_F(Audit, AWorkerThatLiedIsFound) {
  site.submit(small_sweep("s"));
  site.start_worker();
  ASSERT_TRUE(site.run_to_end());
  site.kill_coordinator();
  // As if worker 1 had computed something else: consistent in itself.
  site.write("UPDATE job SET digest = zeroblob(32) WHERE job = 17");
  site.start_coordinator();
  site.start_worker();
  const auto begun = audit(1);
  EXPECT_EQ(begun.jobs(), 96U);
  site.kill_coordinator();
  site.start_coordinator();
  ASSERT_TRUE(site.run_until([&] { return look(begun.audit()).state() == "finished"; })) << "also over a restart";
  EXPECT_EQ(look(begun.audit()).diverged(), 1U);
  EXPECT_EQ(site.number("SELECT count(*) FROM divergence WHERE job = 17"), 1U);
  EXPECT_EQ(status().divergences(), 1U);
}

TEST_F(Audit, AShareThatIsNoneIsRefused) {
  idl::Request request;
  request.mutable_audit()->set_sweep("s");
  request.mutable_audit()->set_share(1.5);
  EXPECT_THAT(site.ask(request).error().messages(0), HasSubstr("above 0 and at most 1"));
}

}  // namespace
}  // namespace lamprey::tests
