// What robots record, from a worker's result to the database.
#include "idl/recording.pb.h"
#include "storage/results_reader.hpp"
#include "tests/coordinator/hand_worker.hpp"
#include "tests/storage/power_cut_vfs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::tests {
namespace {

using messaging::Verdict;
using ::testing::HasSubstr;
using Octets = std::vector<std::uint8_t>;

/// Job 0 is on a robot, job 1 is its simulation.
class RobotRecordings : public testing::Test {
 protected:
  void SetUp() override {
    site.vfs = vfs.name();
    site.start_coordinator();
    site.submit(yaml);
    const auto leases = first.heartbeat();
    ASSERT_FALSE(leases.empty());
    origin = leases.front().origin;
    second.heartbeat();
  }

  messaging::JobResult result(std::uint64_t job, double total, const Octets& recording) const {
    messaging::JobResult made;
    made.job = job;
    made.identity = experiment::identity(grid.job(job));
    made.outcome.cycles = 40;
    made.outcome.initial.total = made.outcome.final.total = total;
    made.outcome.evolved = made.outcome.highest = made.outcome.final;
    made.digest = experiment::outcome_digest(made.identity, made.outcome);
    made.recording = recording;
    return made;
  }
  messaging::JobResult failed(const Octets& recording) const {
    messaging::JobResult made;
    made.identity = experiment::identity(grid.job(0));
    made.kind = messaging::ResultKind::failed;
    made.reason = "an evaluation was void 20 times in a row";
    made.recording = recording;
    return made;
  }

  /// One evaluation of two time steps, under that claim.
  static Octets recording(std::uint64_t token) {
    idl::RobotRecording message;
    message.set_robot("lamprey-1");
    message.set_token(token);
    auto& tried = *message.add_evaluations();
    for (int row = 0; row < 3; ++row) {
      for (int servo = 0; servo < 8; ++servo) {
        tried.add_commanded(1000 + 100 * row);
        tried.add_reported(1000 + 90 * row);
      }
      tried.add_feet_down(15);
    }
    const std::string text = message.SerializeAsString();
    return {text.begin(), text.end()};
  }

  messaging::Acknowledgement answer(HandWorker& worker, const messaging::JobResult& sent) {
    const auto answers = worker.send(origin, sweep, sent);
    if (answers.size() != 1) throw std::runtime_error(std::to_string(answers.size()) + " answers");
    return answers[0];
  }
  Verdict verdict(HandWorker& worker, const messaging::JobResult& sent) { return answer(worker, sent).verdict; }

  std::uint64_t recordings(const std::string& where = "1") {
    return site.number("SELECT count(*) FROM recording WHERE " + where);
  }
  std::string metrics() {
    idl::Request request;
    request.mutable_metrics();
    return site.ask(request).metrics().text();
  }
  void expect_in_order() {
    const auto verification = storage::verify(site.database().string());
    for (const auto& found : verification.discrepancies) ADD_FAILURE() << found.column << ": " << found.text;
    EXPECT_EQ(site.number("SELECT count(*) FROM divergence"), 0U);
  }

  std::string yaml = "name: robots\nseed: 7\nbase: {cycles: 40}\ngrids:\n  - {robot: [bridge, quadruped]}\n";
  idl::SweepSpecification specification = experiment::parse_sweep(yaml, "test").specification;
  experiment::SweepGrid grid{specification};
  experiment::Id128 sweep = experiment::sweep_id(specification);
  storage::testing::PowerCutVfs vfs;
  Site site;
  HandWorker first{site, 0x71};
  HandWorker second{site, 0x72};
  messaging::Origin origin;
};

TEST_F(RobotRecordings, AreStoredWithTheRowThatTheyBelongTo) {
  EXPECT_EQ(verdict(first, result(0, 1, recording(5))), Verdict::committed);
  EXPECT_EQ(site.rows("state = 'done'"), 1U);
  EXPECT_EQ(recordings("job = 0 AND number = 1 AND accepted = 1 AND state = 'done' AND robot = 'lamprey-1' AND "
                       "token = 5 AND worker = 0x71"),
            1U);
  EXPECT_EQ(site.number("SELECT count(*) FROM motion WHERE step = 2 AND commanded = 12 AND reported = 11.8"), 8U);
  EXPECT_EQ(site.number("SELECT count(*) FROM result WHERE repeatability = 'physical'"), 1U);
  expect_in_order();
}

TEST_F(RobotRecordings, AnotherAttemptIsNoDivergenceAndIsKeptBesideTheOneThatCounts) {
  ASSERT_EQ(verdict(first, result(0, 1, recording(5))), Verdict::committed);
  const auto other = answer(second, result(0, 2, recording(6)));
  EXPECT_EQ(other.verdict, Verdict::duplicate);
  EXPECT_THAT(other.reason, HasSubstr("this one is kept"));
  EXPECT_EQ(recordings("token = 6 AND number = 2 AND accepted = 0"), 1U);
  EXPECT_EQ(recordings("accepted = 1"), 1U);
  EXPECT_EQ(site.number("SELECT count(*) FROM result WHERE final_total = 1"), 1U);

  const auto without = answer(second, result(0, 3, {}));
  EXPECT_EQ(without.verdict, Verdict::duplicate);
  EXPECT_EQ(without.reason, "another attempt is the job's row");
  EXPECT_EQ(verdict(first, failed(recording(7))), Verdict::duplicate);
  EXPECT_EQ(recordings("token = 7 AND state = 'failed' AND accepted = 0"), 1U);
  expect_in_order();
}

TEST_F(RobotRecordings, AttemptsThatAgreeToTheBitAreBothKept) {
  ASSERT_EQ(verdict(first, result(0, 1, recording(5))), Verdict::committed);
  EXPECT_THAT(answer(second, result(0, 1, recording(5))).reason, HasSubstr("this one is kept"));
  EXPECT_EQ(recordings(), 2U);
  expect_in_order();
}

TEST_F(RobotRecordings, TheSameResultSentAgainIsStoredOnce) {
  ASSERT_EQ(verdict(first, result(0, 1, recording(5))), Verdict::committed);
  const auto again = answer(first, result(0, 1, recording(5)));
  EXPECT_EQ(again.verdict, Verdict::duplicate);
  EXPECT_EQ(again.reason, "");
  EXPECT_EQ(recordings(), 1U);
  for (int time = 0; time < 2; ++time) EXPECT_EQ(verdict(second, result(0, 2, recording(6))), Verdict::duplicate);
  EXPECT_EQ(recordings(), 2U);
  expect_in_order();
}

TEST_F(RobotRecordings, OfAFailedAttemptStaysWhenTheJobIsTriedAgain) {
  ASSERT_EQ(verdict(first, failed(recording(5))), Verdict::committed);
  EXPECT_EQ(recordings("state = 'failed' AND accepted = 0 AND number = 1"), 1U);
  idl::Request request;
  request.mutable_control()->set_sweep("robots");
  request.mutable_control()->set_action(idl::ControlRequest::RETRY);
  ASSERT_TRUE(site.ask(request).has_control());
  ASSERT_EQ(verdict(first, result(0, 1, recording(6))), Verdict::committed);
  EXPECT_EQ(recordings("state = 'done' AND accepted = 1 AND number = 2"), 1U);
  EXPECT_EQ(recordings(), 2U);
  expect_in_order();
}

TEST_F(RobotRecordings, NonsenseIsDroppedAndCountedAndTheResultStands) {
  ASSERT_EQ(verdict(first, result(0, 1, {0x1a, 0xff})), Verdict::committed);
  EXPECT_EQ(recordings(), 0U);
  EXPECT_THAT(metrics(), HasSubstr("lamprey_recordings_dropped_total 1\n"));
  // Of the simulated job, and of one that claims to be another.
  ASSERT_EQ(verdict(first, result(1, 1, recording(5))), Verdict::committed);
  auto of_another = failed(recording(5));
  of_another.identity[0] ^= 1;
  EXPECT_EQ(answer(second, of_another).reason, "another attempt is the job's row");
  EXPECT_EQ(recordings(), 0U);
  EXPECT_THAT(metrics(), HasSubstr("lamprey_recordings_dropped_total 3\n"));
  EXPECT_EQ(site.rows("state = 'done'"), 2U);
  expect_in_order();
}

TEST_F(RobotRecordings, AreKeptForASweepThatHasEnded) {
  ASSERT_EQ(verdict(first, result(0, 1, recording(5))), Verdict::committed);
  ASSERT_EQ(verdict(first, result(1, 1, {})), Verdict::committed);
  ASSERT_TRUE(site.ended());
  site.kill_coordinator();
  site.start_coordinator();
  second.heartbeat();
  EXPECT_THAT(answer(second, result(0, 2, recording(6))).reason, HasSubstr("this one is kept"));
  EXPECT_EQ(recordings("accepted = 0"), 1U);
  EXPECT_EQ(verdict(second, result(1, 2, {})), Verdict::divergent) << "the simulated one must agree";
}

TEST_F(RobotRecordings, WaitOnceWhileNothingCanBeStored) {
  vfs.fail_from(1, SQLITE_FULL);
  for (int time = 0; time < 3; ++time) EXPECT_TRUE(first.send(origin, sweep, result(0, 1, recording(5))).empty());
  for (int time = 0; time < 3; ++time) EXPECT_TRUE(second.send(origin, sweep, result(0, 2, recording(6))).empty());
  vfs.repair();
  site.advance(std::chrono::seconds{3});
  EXPECT_EQ(site.rows("state = 'done'"), 1U);
  EXPECT_EQ(recordings("accepted = 1 AND token = 5"), 1U);
  EXPECT_EQ(recordings(), 2U);
  expect_in_order();
}

}  // namespace
}  // namespace lamprey::tests
