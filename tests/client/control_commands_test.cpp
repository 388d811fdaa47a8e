#include "experiment/sweep.hpp"
#include "tests/client/scripted_coordinator.hpp"

#include <gtest/gtest.h>

namespace lamprey::tests {
namespace {

using Arguments = std::vector<std::string>;
using Action = idl::ControlRequest;

idl::Reply control_reply(const std::string& state, std::uint64_t jobs) {
  idl::Reply reply;
  reply.mutable_control()->set_state(state);
  reply.mutable_control()->set_jobs(jobs);
  return reply;
}

class ControlCommandsTest : public testing::Test {
 protected:
  Site site;

  /// The one request that the command sends, and how it ends.
  idl::Request request_of(const Arguments& arguments, const idl::Reply& reply, ToolRun* run = nullptr) {
    ScriptedCoordinator coordinator(site, [&](const auto&) { return reply; });
    const auto result = site.run(arguments);
    if (run != nullptr) *run = result;
    const auto requests = coordinator.requests();
    EXPECT_EQ(requests.size(), 1U) << result.err;
    return requests.empty() ? idl::Request() : requests.front();
  }
};

struct Steering {
  Arguments arguments;
  Action::Action action;
  std::string state;
  std::string says;
};

class SteeringTest : public ControlCommandsTest, public testing::WithParamInterface<Steering> {};

TEST_P(SteeringTest, AsksForItAndSaysWhatHasBecomeOfIt) {
  const auto& [arguments, action, state, says] = GetParam();
  ToolRun run;
  const auto request = request_of(arguments, control_reply(state, 12), &run);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(request.control().sweep(), "small");
  EXPECT_EQ(request.control().action(), action);
  EXPECT_NE(run.out.find(says), std::string::npos) << run.out;

  auto with_json = arguments;
  with_json.insert(with_json.end(), {"--format", "json"});
  request_of(with_json, control_reply(state, 12), &run);
  EXPECT_EQ(run.json()["schema"], "lamprey/" + arguments[0] + "/1");
  EXPECT_EQ(run.json()["sweep"], "small");
  EXPECT_EQ(run.json()["state"], state);
  EXPECT_EQ(run.json()["jobs"], 12);
}

INSTANTIATE_TEST_SUITE_P(
    All, SteeringTest,
    testing::Values(Steering{{"pause", "small"}, Action::PAUSE, "paused", "is paused, 12 jobs pending"},
                    Steering{{"resume", "small"}, Action::RESUME, "running", "is running, 12 jobs pending"},
                    Steering{{"retry", "small"}, Action::RETRY, "running", "12 jobs are pending again"},
                    Steering{{"archive", "small"}, Action::ARCHIVE, "finished", "lamprey status --all"},
                    Steering{{"archive", "small", "--undo"}, Action::UNARCHIVE, "finished", "in lamprey status again"},
                    Steering{{"delete", "small", "--yes"}, Action::DELETE, "deleting", "12 jobs being deleted"}),
    [](const auto& each) { return each.param.arguments[0] + std::to_string(each.index); });

TEST_F(ControlCommandsTest, RetryTakesCancelledJobsOnlyWhereToldTo) {
  EXPECT_FALSE(request_of({"retry", "small"}, control_reply("running", 1)).control().cancelled_too());
  EXPECT_TRUE(request_of({"retry", "small", "--cancelled"}, control_reply("running", 1)).control().cancelled_too());
  ToolRun run;
  request_of({"retry", "small"}, control_reply("finished", 0), &run);
  EXPECT_NE(run.out.find("nothing to try again"), std::string::npos) << run.out;
}

TEST_F(ControlCommandsTest, DeletingWithoutYesOnlySaysWhatWouldGo) {
  idl::Reply reply;
  reply.mutable_status()->set_database("/data/c.db");
  auto& sweep = *reply.mutable_status()->add_sweeps();
  sweep.set_name("small");
  sweep.set_state("finished");
  sweep.mutable_counts()->set_jobs(8);
  sweep.mutable_counts()->set_done(7);
  sweep.mutable_counts()->set_failed(1);
  ToolRun run;
  const auto request = request_of({"delete", "small"}, reply, &run);
  EXPECT_TRUE(request.has_status()) << "nothing was asked for that changes anything";
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("/data/c.db for ever (8 jobs: 7 done, 1 failed)"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("lamprey delete small --yes"), std::string::npos) << run.err;

  sweep.set_state("running");
  request_of({"delete", "small", "--format", "json"}, reply, &run);
  EXPECT_EQ(run.json()["error"]["code"], "not_confirmed");
  EXPECT_NE(run.err.find("lamprey cancel small"), std::string::npos) << run.err;
}

TEST_F(ControlCommandsTest, ResumeShowsHowTheFileDiffersFromTheDatabase) {
  const auto file = site.file("small.yaml", small_sweep);
  ToolRun run;
  const auto request = request_of({"resume", "small", file},
                                  error_reply("sweep_changed", {"seed: 6, now 7", "base.cycles: 10, now 20"}), &run);
  EXPECT_EQ(request.control().specification().name(), "small");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("small.yaml is not sweep 'small' as the database has it"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("\n  seed: 6, now 7\n  base.cycles: 10, now 20\n"), std::string::npos) << run.err;
  EXPECT_EQ(request_of({"resume", "other", file, "--name", "other"}, control_reply("running", 1))
                .control()
                .specification()
                .name(),
            "other");
  EXPECT_FALSE(request_of({"resume", "small"}, control_reply("running", 1)).control().has_specification());
}

TEST_F(ControlCommandsTest, SubmitShowsHowASweepOfThatNameDiffers) {
  const auto file = site.file("small.yaml", small_sweep);
  ToolRun run;
  request_of({"submit", file, "--format", "json"}, error_reply("sweep_changed", {"seed: 6, now 7"}), &run);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.json()["error"]["code"], "sweep_changed");
  EXPECT_EQ(run.json()["error"]["details"], client::Json::parse(R"(["seed: 6, now 7"])"));
  EXPECT_NE(run.err.find("sweep 'small' is in the database with another specification"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("--name NAME"), std::string::npos) << run.err;
}

TEST_F(ControlCommandsTest, SubmitTakesWhatTheCommandLineSaysInTheFilesPlace) {
  const auto file = site.file("small.yaml", std::string(small_sweep) + "priority: 1\ntags: [a]\n");
  ScriptedCoordinator coordinator(site, [](const idl::Request& request) {
    idl::Reply reply;
    if (request.has_submit()) {
      reply.mutable_submit()->set_jobs(8);
    } else {
      reply.mutable_status()->add_sweeps()->set_reused(3);
    }
    return reply;
  });
  const auto run = site.run({"submit", file, "--name", "other", "--priority", "-5", "--tag", "b", "--tag", "a",
                             "--fail-fast", "--fresh", "--format", "json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.json()["sweep"], "other");
  EXPECT_EQ(run.json()["reused"], 3);
  const auto submitted = coordinator.requests().at(0).submit();
  EXPECT_TRUE(submitted.fresh());
  EXPECT_EQ(submitted.specification().name(), "other");
  const auto& execution = submitted.specification().execution();
  EXPECT_EQ(execution.priority(), -5);
  EXPECT_TRUE(execution.fail_fast());
  ASSERT_EQ(execution.tags_size(), 2);
  EXPECT_EQ(execution.tags(1), "b");
  // It is known by what it is: another name makes another sweep, the rest does not.
  auto same = experiment::parse_sweep(small_sweep, "small.yaml").specification;
  same.set_name("other");
  EXPECT_EQ(experiment::sweep_id(submitted.specification()), experiment::sweep_id(same));
}

TEST_F(ControlCommandsTest, WhatTheCommandLineSaysIsCheckedBeforeAnythingIsSent) {
  const auto file = site.file("small.yaml", small_sweep);
  const auto run = site.run({"submit", file, "--name", "a b", "--tag", "x y"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("name: 'a b' is not allowed"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("tags[0]: 'x y' is not allowed: a tag has 1 to 64 letters"), std::string::npos) << run.err;
}

TEST_F(ControlCommandsTest, AdjustSendsOnlyWhatChanges) {
  ToolRun run;
  auto request = request_of({"adjust", "small", "--priority", "-7"}, control_reply("running", 8), &run).adjust();
  EXPECT_EQ(request.priority(), -7);
  EXPECT_FALSE(request.has_max_concurrent());
  EXPECT_EQ(run.out, "Sweep small: priority -7.\n");
  request =
      request_of({"adjust", "small", "--max-concurrent", "0", "--format", "json"}, control_reply("running", 8), &run)
          .adjust();
  EXPECT_FALSE(request.has_priority());
  EXPECT_TRUE(request.has_max_concurrent());
  EXPECT_EQ(request.max_concurrent(), 0U);
  EXPECT_EQ(run.json()["max_concurrent"], nullptr);
}

TEST_F(ControlCommandsTest, RenameSendsTheNewName) {
  ToolRun run;
  const auto request = request_of({"rename", "small", "large", "--format", "json"}, control_reply("finished", 8), &run);
  EXPECT_EQ(request.rename().sweep(), "small");
  EXPECT_EQ(request.rename().name(), "large");
  EXPECT_EQ(run.json()["name"], "large");
}

TEST_F(ControlCommandsTest, DrainNamesTheWorkersThatLeave) {
  idl::Reply reply;
  reply.mutable_drain()->add_workers("0000000000000abc");
  reply.mutable_drain()->add_workers("0000000000000abd");
  ToolRun run;
  EXPECT_EQ(request_of({"drain", "node7"}, reply, &run).drain().worker(), "node7");
  EXPECT_EQ(run.out,
            "Worker 0000000000000abc finishes what it holds and leaves.\n"
            "Worker 0000000000000abd finishes what it holds and leaves.\n");
}

TEST_F(ControlCommandsTest, MetricsAreGivenAsTheyAre) {
  idl::Reply reply;
  reply.mutable_metrics()->set_text("# TYPE lamprey_jobs counter\nlamprey_jobs 5\n");
  ToolRun run;
  request_of({"metrics"}, reply, &run);
  EXPECT_EQ(run.out, reply.metrics().text());
  request_of({"metrics", "--format", "json"}, reply, &run);
  EXPECT_EQ(run.json()["text"], reply.metrics().text());
}

TEST_F(ControlCommandsTest, RefusalsEndWithTwoAndFaultsOfTheDatabaseWithSix) {
  ToolRun run;
  request_of({"pause", "small"}, error_reply("not_possible", {"sweep small is finished; it cannot be paused"}), &run);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.err, "lamprey: error: sweep small is finished; it cannot be paused\n");
  request_of({"drain", "x"}, error_reply("unknown_worker", {"no worker 'x'"}), &run);
  EXPECT_EQ(run.exit_code, 2);
  request_of({"retry", "small"}, error_reply("storage", {"disk full"}), &run);
  EXPECT_EQ(run.exit_code, 6);
  request_of({"retry", "small"}, error_reply("internal", {"a defect"}), &run);
  EXPECT_EQ(run.exit_code, 1);
}

}  // namespace
}  // namespace lamprey::tests
