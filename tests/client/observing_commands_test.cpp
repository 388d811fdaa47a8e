#include "messaging/qos.hpp"
#include "tests/client/scripted_coordinator.hpp"

#include <gtest/gtest.h>

// What only looks: status, workers, trace, events, audit, watch.

namespace lamprey::tests {
namespace {

using client::Json;

idl::Reply status_reply() {
  idl::Reply reply;
  auto& status = *reply.mutable_status();
  status.set_database("/data/c.db");
  status.set_epoch(3);
  auto& sweep = *status.add_sweeps();
  sweep.set_name("small");
  sweep.set_id("000000000000000300000000000000ff");
  sweep.set_state("running");
  sweep.mutable_counts()->set_jobs(8);
  sweep.mutable_counts()->set_done(4);
  sweep.mutable_counts()->set_pending(4);
  auto& worker = *status.add_workers();
  worker.set_worker("0000000000000abc");
  worker.set_host("node7");
  worker.set_process(42);
  worker.set_state("ready");
  worker.set_results_held(5);
  worker.set_seconds_since_heard(0.3);
  worker.add_labels("gpu=1");
  auto& running = *worker.add_running();
  running.set_sweep("small");
  running.set_job(6);
  running.set_cycle(1234);
  running.set_seconds(2.5);
  return reply;
}

void add_event(idl::Reply& reply, std::uint64_t number, const std::string& kind, const std::string& text) {
  auto& event = *reply.mutable_events()->add_events();
  event.set_event(number);
  event.set_at(1'769'860'800'000);
  event.set_kind(kind);
  event.set_sweep("small");
  event.set_text(text);
}

std::vector<Json> documents(const std::string& lines) {
  std::vector<Json> all;
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) all.push_back(Json::parse(line, nullptr, false));
  return all;
}

class ObservingCommandsTest : public testing::Test {
 protected:
  Site site;

  ToolRun run_with(const idl::Reply& reply, const std::vector<std::string>& arguments) {
    const ScriptedCoordinator coordinator(site, [&](const auto&) { return reply; });
    return site.run(arguments);
  }
};

TEST_F(ObservingCommandsTest, StatusEndsWithFiveWhereASweepThatItShowsDiverges) {
  auto reply = status_reply();
  EXPECT_EQ(run_with(reply, {"status"}).exit_code, 0);
  auto& sweep = *reply.mutable_status()->mutable_sweeps(0);
  sweep.set_divergences(2);
  const auto run = run_with(reply, {"status"});
  EXPECT_EQ(run.exit_code, 5);
  EXPECT_NE(run.out.find("2 results diverge"), std::string::npos) << run.out;
  sweep.set_archived(true);
  EXPECT_EQ(run_with(reply, {"status"}).exit_code, 0) << "it is not shown";
  EXPECT_EQ(run_with(reply, {"status", "--all", "--format", "json"}).exit_code, 5);
}

TEST_F(ObservingCommandsTest, StatusHidesArchivedSweepsUnlessAskedFor) {
  auto reply = status_reply();
  auto& old = *reply.mutable_status()->add_sweeps();
  old.set_name("ancient");
  old.set_state("finished");
  old.set_archived(true);
  const auto run = run_with(reply, {"status"});
  EXPECT_EQ(run.out.find("ancient"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("1 archived sweep: --all"), std::string::npos) << run.out;
  EXPECT_NE(run_with(reply, {"status", "--all"}).out.find("finished, archived"), std::string::npos);
  EXPECT_EQ(run_with(reply, {"status", "--format", "json"}).json()["sweeps"].size(), 1U);
  EXPECT_EQ(run_with(reply, {"status", "--all", "--format", "json"}).json()["sweeps"][1]["archived"], true);
}

TEST_F(ObservingCommandsTest, StatusShowsRareColumnsOnlyWhereTheyTell) {
  auto reply = status_reply();
  auto out = run_with(reply, {"status"}).out;
  for (const auto* rare : {"priority", "reused", "audited", "quarantined", "cancelled", "tags"}) {
    EXPECT_EQ(out.find(rare), std::string::npos) << rare << out;
  }
  auto& sweep = *reply.mutable_status()->mutable_sweeps(0);
  sweep.set_state("paused");
  sweep.set_reason("the disk is full");
  sweep.set_reused(3);
  sweep.mutable_execution()->set_priority(-7);
  sweep.mutable_execution()->set_max_concurrent(64);
  sweep.mutable_execution()->add_needs("gpu=1");
  out = run_with(reply, {"status", "small"}).out;
  for (const auto* told :
       {"priority", "-7", "reused", "paused: the disk is full", "at most 64 jobs at once", "needs gpu=1"}) {
    EXPECT_NE(out.find(told), std::string::npos) << told << out;
  }
  const auto json = run_with(reply, {"status", "--format", "json"}).json()["sweeps"][0];
  EXPECT_EQ(json["priority"], -7);
  EXPECT_EQ(json["max_concurrent"], 64);
  EXPECT_EQ(json["time_limit"], nullptr);
  EXPECT_EQ(json["reused"], 3);
  EXPECT_EQ(json["reason"], "the disk is full");
}

TEST_F(ObservingCommandsTest, AStorageFaultIsToldLoudly) {
  auto reply = status_reply();
  reply.mutable_status()->set_storage_fault("no space left");
  for (const auto* command : {"status", "workers"}) {
    const auto run = run_with(reply, {command});
    EXPECT_NE(run.err.find("STORAGE FAULT: nothing can be stored: no space left"), std::string::npos) << run.err;
  }
  EXPECT_EQ(run_with(reply, {"status", "--format", "json"}).json()["storage_fault"], "no space left");
  EXPECT_NE(run_with(reply, {"watch", "--once"}).out.find("STORAGE FAULT"), std::string::npos);
}

TEST_F(ObservingCommandsTest, WorkersSaysWhatEachIsComputing) {
  const auto reply = status_reply();
  const auto run = run_with(reply, {"workers"});
  for (const auto* told :
       {"0000000000000abc", "node7/42", "gpu=1", "0.3 s ago", "job 6 of small: cycle 1,234, 2.5 s"}) {
    EXPECT_NE(run.out.find(told), std::string::npos) << told << run.out;
  }
  const auto json = run_with(reply, {"workers", "--format", "json"}).json();
  EXPECT_EQ(json["schema"], "lamprey/workers/1");
  EXPECT_EQ(json["workers"][0]["results_held"], 5);
  EXPECT_EQ(json["workers"][0]["running"][0]["cycle"], 1234);
}

TEST_F(ObservingCommandsTest, ControlCharactersFromTheNetworkDoNotReachTheTerminal) {
  auto reply = status_reply();
  auto& sweep = *reply.mutable_status()->mutable_sweeps(0);
  sweep.set_reason("\x1b[2J");
  reply.mutable_status()->mutable_workers(0)->set_host("\x1b[2J\xc2\x9b");
  reply.mutable_status()->mutable_workers(0)->set_labels(0, "\x1b[2J");
  for (const auto* command : {"status", "workers"}) {
    const auto run = run_with(reply, {command});
    EXPECT_EQ(run.out.find('\x1b'), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find('\x9b'), std::string::npos) << run.out;
  }
  idl::Reply events;
  add_event(events, 1, "job_quarantined", "\x1b[2J");
  EXPECT_EQ(run_with(events, {"events"}).out.find('\x1b'), std::string::npos);
}

TEST_F(ObservingCommandsTest, EventsShowsTheNewestOrAllAfterANumber) {
  const auto answer = [](const idl::Request& request) {
    const auto& asked = request.events();
    idl::Reply reply;
    reply.mutable_events();
    if (asked.after() == 0) {
      add_event(reply, 9, "sweep_finished", "small");
    } else if (asked.after() < 9) {
      add_event(reply, asked.after() + 1, "lease_lost", "12 jobs");
    }
    return reply;
  };
  const ScriptedCoordinator coordinator(site, answer);
  EXPECT_EQ(site.run({"events", "small"}).out, "2026-01-31 12:00:00  sweep_finished       small\n");
  EXPECT_EQ(coordinator.requests().at(0).events().limit(), 20U);
  EXPECT_EQ(coordinator.requests().at(0).events().sweep(), "small");
  const auto json = site.run({"events", "--after", "5", "--format", "json"}).json();
  EXPECT_EQ(json["schema"], "lamprey/events/1");
  ASSERT_EQ(json["events"].size(), 4U) << "page by page";
  EXPECT_EQ(json["events"][0]["event"], 6);
  EXPECT_EQ(json["events"][3]["event"], 9);
  EXPECT_EQ(json["events"][3]["text"], "12 jobs");
  EXPECT_EQ(json["events"][3]["job"], nullptr);
  EXPECT_EQ(site.run({"events", "--after", "5", "--limit", "2", "--format", "json"}).json()["events"].size(), 2U);
}

TEST_F(ObservingCommandsTest, FollowingEventsGoesOnUntilCtrlC) {
  const ScriptedCoordinator coordinator(site, [this](const idl::Request& request) {
    idl::Reply reply;
    reply.mutable_events();
    const auto after = request.events().after();
    if (after == 3) {
      site.interrupted = true;
    } else {
      add_event(reply, after + 1, "lease_lost", "");
    }
    return reply;
  });
  const auto run = site.run({"events", "--follow", "--format", "json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto lines = documents(run.out);
  ASSERT_EQ(lines.size(), 3U) << run.out;
  EXPECT_EQ(lines[2]["events"][0]["event"], 3);
}

idl::Reply trace_reply(std::uint64_t first, std::uint64_t count, bool more, const std::string& state) {
  idl::Reply reply;
  auto& trace = *reply.mutable_trace();
  for (std::uint64_t i = first; i < first + count; ++i) {
    auto& row = *trace.add_rows();
    row.set_cycle(10 * i);
    row.set_stability(50.5);
    row.set_total(0.1 + 0.2);
  }
  trace.set_more(more);
  trace.set_state(state);
  trace.set_cycle(10 * (first + count));
  trace.set_cycles(100);
  return reply;
}

TEST_F(ObservingCommandsTest, ATraceComesWholeHoweverManyPagesItTakes) {
  const ScriptedCoordinator coordinator(site, [](const idl::Request& request) {
    const auto first = request.trace().first_row();
    return trace_reply(first, 2, first < 4, "done");
  });
  const auto json = site.run({"trace", "small", "7", "--format", "json"}).json();
  EXPECT_EQ(json["schema"], "lamprey/trace/1");
  EXPECT_EQ(json["job"], 7);
  EXPECT_EQ(json["state"], "done");
  ASSERT_EQ(json["rows"].size(), 6U);
  EXPECT_EQ(json["rows"][5]["cycle"], 50);
  const auto csv = site.run({"trace", "small", "7", "--format", "csv"}).out;
  EXPECT_TRUE(csv.starts_with("cycle,stability,distance,fuel,total\n0,50.5,0,0,0.30000000000000004\n10,")) << csv;
  const auto table = site.run({"trace", "small", "7"}).out;
  EXPECT_NE(table.find("\n        50        50.5           0           0         0.3\n"), std::string::npos) << table;
  EXPECT_NE(table.find("job 7 of small: done, 60 of 100 cycles, 6 changes accepted"), std::string::npos) << table;
}

TEST_F(ObservingCommandsTest, ATraceIsFollowedUntilTheJobEnds) {
  const ScriptedCoordinator coordinator(site, [](const idl::Request& request) {
    const auto first = request.trace().first_row();
    return first < 3 ? trace_reply(first, 1, false, "running") : trace_reply(first, 1, false, "done");
  });
  const auto run = site.run({"trace", "small", "7", "--follow", "--format", "json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto lines = documents(run.out);
  ASSERT_EQ(lines.size(), 4U) << run.out;
  EXPECT_EQ(lines[0]["state"], "running");
  EXPECT_EQ(lines[0]["rows"].size(), 1U);
  EXPECT_EQ(lines[3]["state"], "done");
  EXPECT_EQ(lines[3]["rows"][0]["cycle"], 30);
}

TEST_F(ObservingCommandsTest, ATraceOfADatabaseIsTheStoredOne) {
  const auto database = site.database(small_sweep, 5);
  const auto json = site.run({"trace", "small", "2", "--database", database, "--format", "json"}).json();
  EXPECT_EQ(json["state"], "done");
  EXPECT_EQ(json["cycles"], 20);
  const auto replayed = site.run({"replay", "small", "2", "--database", database, "--format", "json"}).json();
  EXPECT_EQ(json["rows"].size(), replayed["outcome"]["accepted"]);
  EXPECT_EQ(site.run({"trace", "small", "6", "--database", database}).exit_code, 2);
  EXPECT_EQ(site.run({"trace", "smal", "6", "--database", database}).exit_code, 2);
  EXPECT_EQ(site.run({"trace", "small", "2", "--database", database, "--follow"}).exit_code, 2);
}

idl::Reply audit_reply(std::uint64_t agreed, std::uint64_t diverged, std::uint64_t waiting) {
  idl::Reply reply;
  auto& audit = *reply.mutable_audit();
  audit.set_audit("00ff");
  audit.set_sweep("small");
  audit.set_jobs(3);
  audit.set_agreed(agreed);
  audit.set_diverged(diverged);
  audit.set_waiting_for_another_worker(waiting);
  audit.set_state(agreed + diverged == 3 ? "finished" : "running");
  return reply;
}

TEST_F(ObservingCommandsTest, AnAuditIsFollowedToItsEndAndADivergenceEndsWithFive) {
  std::uint64_t asked = 0;
  std::uint64_t diverged = 0;
  const ScriptedCoordinator coordinator(site, [&](const idl::Request& request) {
    if (request.has_audit()) asked = 0;
    const auto ended = asked++;
    return audit_reply(std::min(ended, 3 - diverged), ended >= 2 ? diverged : 0, 0);
  });
  const auto good = site.run({"audit", "small", "--share", "12.5%", "--seed", "9", "-q", "--format", "json"});
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_EQ(good.json()["schema"], "lamprey/audit/1");
  EXPECT_EQ(good.json()["state"], "finished");
  EXPECT_EQ(good.json()["agreed"], 3);
  const auto requests = coordinator.requests();
  EXPECT_EQ(requests.at(0).audit().share(), 0.125);
  EXPECT_EQ(requests.at(0).audit().seed(), 9U);
  EXPECT_EQ(requests.at(1).audit_status().audit(), "00ff");
  diverged = 1;
  const auto bad = site.run({"audit", "small"});
  EXPECT_EQ(bad.exit_code, 5) << bad.err;
  EXPECT_NE(bad.out.find("1 (see the table divergence)"), std::string::npos) << bad.out;
}

TEST_F(ObservingCommandsTest, AnAuditSaysThatItWaitsForAnotherWorker) {
  const auto run = run_with(audit_reply(1, 0, 2), {"audit", "small", "--no-wait"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("2 jobs wait for a worker other than the one"), std::string::npos) << run.out;
  const ScriptedCoordinator coordinator(site, [this](const idl::Request& request) {
    if (request.has_audit_status()) site.interrupted = true;
    return audit_reply(1, 0, 2);
  });
  const auto interrupted = site.run({"audit", "small"});
  EXPECT_EQ(interrupted.exit_code, 130);
  EXPECT_NE(interrupted.err.find("2 jobs wait for a worker"), std::string::npos) << interrupted.err;
  EXPECT_NE(interrupted.err.find("the audit goes on"), std::string::npos) << interrupted.err;
}

/// Answers a watch: its first picture, then as `then` changes it.
ScriptedCoordinator::Answer watch_answers(const std::function<void(idl::StatusReply&, int)>& then) {
  return [=, count = 0](const idl::Request& request) mutable {
    if (request.has_status()) {
      auto reply = status_reply();
      then(*reply.mutable_status(), count++);
      return reply;
    }
    idl::Reply reply;
    reply.mutable_events();
    if (request.events().after() == 0) add_event(reply, 4, "sweep_submitted", "8 jobs");
    if (request.events().after() == 4 && count > 1) add_event(reply, 5, "lease_lost", "2 jobs");
    return reply;
  };
}

TEST_F(ObservingCommandsTest, WatchingOnceShowsSweepsWorkersAndEvents) {
  const ScriptedCoordinator coordinator(site, watch_answers([](auto&, int) {}));
  const auto run = site.run({"watch", "--once"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const auto* told : {"/data/c.db", "############............  50 %", "node7/42", "sweep_submitted", "8 jobs"}) {
    EXPECT_NE(run.out.find(told), std::string::npos) << told << '\n' << run.out;
  }
  EXPECT_EQ(run.out.find('\x1b'), std::string::npos) << "no terminal";
  const auto json = site.run({"watch", "--once", "--format", "json"}).json();
  EXPECT_EQ(json["schema"], "lamprey/watch/1");
  EXPECT_EQ(json["sweeps"][0]["counts"]["done"], 4);
  EXPECT_EQ(json["workers"].size(), 1U);
  EXPECT_EQ(json["events"][0]["event"], 4);
}

TEST_F(ObservingCommandsTest, WatchingASweepOnAPipeWritesEachChangeUntilItEnds) {
  const auto change = [](idl::StatusReply& status, int count) {
    if (count == 0) return;
    auto& sweep = *status.mutable_sweeps(0);
    sweep.set_state("finished");
    sweep.mutable_counts()->set_done(7);
    sweep.mutable_counts()->set_failed(1);
    sweep.mutable_counts()->set_pending(0);
  };
  {
    const ScriptedCoordinator coordinator(site, watch_answers(change));
    const auto run = site.run({"watch", "small"});
    EXPECT_EQ(run.exit_code, 4) << run.err;
    EXPECT_NE(run.out.find("small  4 / 8  50 %"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("lease_lost"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("small  8 / 8  100 %  done 7  failed 1"), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("sweep_submitted"), std::string::npos) << "that was before" << run.out;
    EXPECT_EQ(coordinator.requests().at(0).status().sweep(), "small");
  }
  const ScriptedCoordinator coordinator(site, watch_answers(change));
  const auto lines = documents(site.run({"watch", "small", "--format", "json"}).out);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0]["sweeps"][0]["counts"]["done"], 4);
  EXPECT_EQ(lines[1]["sweeps"][0]["state"], "finished");
}

TEST_F(ObservingCommandsTest, WatchingEndsWithCtrlC) {
  const ScriptedCoordinator coordinator(site, watch_answers([this](auto&, int count) {
                                          if (count > 0) site.interrupted = true;
                                        }));
  EXPECT_EQ(site.run({"watch"}).exit_code, 0);
}

TEST_F(ObservingCommandsTest, FollowingWhereNobodyAnswersEndsWithThree) {
  for (const auto& arguments : {std::vector<std::string>{"watch", "--timeout", "0.1"},
                                std::vector<std::string>{"events", "--follow", "--timeout", "0.1"},
                                std::vector<std::string>{"trace", "small", "1", "--follow", "--timeout", "0.1"}}) {
    const auto run = site.run(arguments);
    EXPECT_EQ(run.exit_code, 3) << arguments[0];
    EXPECT_NE(run.err.find("no coordinator answered"), std::string::npos) << run.err;
  }
}

TEST_F(ObservingCommandsTest, NamesTheCoordinatorsThatWereNotMeant) {
  const auto coordinator = [](const std::string& host, const std::string& isolation, std::uint32_t wire) {
    return messaging::discovery::Introduction{
        .role = "coordinator", .host = host, .process = 9, .build = "8.1", .isolation = isolation, .wire = wire};
  };
  const auto elsewhere = site.bus.join("c", coordinator("alpha", "lab2", messaging::wire_version));
  const auto newer = site.bus.join("c", coordinator("beta", "lamprey", messaging::wire_version + 1));
  const auto silent = site.bus.join("c", coordinator("gamma", "lamprey", messaging::wire_version));
  const auto run = site.run({"status", "--timeout", "0.1"});
  EXPECT_EQ(run.exit_code, 3);
  for (const std::string hint :
       {"a coordinator on alpha (process 9) in isolation 'lab2': --isolation lab2",
        "a coordinator on beta (process 9) of another version (8.1), which this tool never meets",
        "a coordinator on gamma (process 9) that does not answer: lamprey doctor looks"}) {
    EXPECT_NE(run.err.find(hint), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace lamprey::tests
