// Long jobs whose workers die, are interrupted or leave: they go on where they were, to the same end.
#include "tests/coordinator/site.hpp"
#include "tests/coordinator/sliced_executor.hpp"

#include <gtest/gtest.h>

namespace lamprey::tests {
namespace {

constexpr std::uint32_t cycles = 400;
constexpr std::uint32_t cycles_per_step = 2;

class Checkpoints : public testing::Test {
 protected:
  Site site;

  void SetUp() override {
    site.start_coordinator();
    site.submit(
        "name: long\nseed: 7\nbase: {cycles: 400, mutation: all}\ngrids:\n  - {required_stability: [25, 50]}\n");
  }
  SlicedExecutor& start_worker() {
    auto executor = std::make_unique<SlicedExecutor>(cycles_per_step);
    auto& reference = *executor;
    site.start_worker(std::move(executor));
    return reference;
  }
  std::uint64_t stored_cycle() { return site.number("SELECT coalesce(max(cycle), 0) FROM checkpoint"); }
  idl::Reply control(idl::ControlRequest::Action action) {
    idl::Request request;
    request.mutable_control()->set_sweep("long");
    request.mutable_control()->set_action(action);
    return site.ask(request);
  }
};

TEST_F(Checkpoints, AKilledWorkersJobGoesOnElsewhere) {
  start_worker();
  ASSERT_TRUE(site.run_until([&] { return stored_cycle() >= 100; }));
  site.kill_worker(0);
  auto& second = start_worker();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_LE(second.cycles_computed, 2 * cycles - 100) << "it did not begin anew";
  EXPECT_EQ(site.number("SELECT count(*) FROM checkpoint"), 0U) << "what has ended needs none";
}

TEST_F(Checkpoints, TheyLastOverARestartOfTheCoordinator) {
  start_worker();
  ASSERT_TRUE(site.run_until([&] { return stored_cycle() >= 100; }));
  site.kill_coordinator();
  site.kill_worker(0);
  site.start_coordinator();
  auto& second = start_worker();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_LE(second.cycles_computed, 2 * cycles - 100);
}

TEST_F(Checkpoints, APausedJobStopsAtOnceAndGoesOnWhereItWas) {
  auto& executor = start_worker();
  ASSERT_TRUE(site.run_until([&] { return stored_cycle() >= 100; }));
  control(idl::ControlRequest::PAUSE);
  site.advance(std::chrono::seconds{1});
  const auto computed = executor.cycles_computed;
  site.advance(std::chrono::seconds{5});
  EXPECT_EQ(executor.cycles_computed, computed);
  control(idl::ControlRequest::RESUME);
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_LE(executor.cycles_computed, 2 * cycles + 4 * cycles_per_step) << "nothing was computed twice";
}

TEST_F(Checkpoints, ALeavingWorkerHandsItsJobOver) {
  auto& first = start_worker();
  ASSERT_TRUE(site.run_until([&] { return stored_cycle() >= 100; }));
  site.worker(0).worker->begin_leaving(site.now);
  site.advance(std::chrono::milliseconds{200});
  site.worker(0).worker->goodbye(site.now);
  const auto computed = first.cycles_computed;
  site.kill_worker(0);
  auto& second = start_worker();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_LE(computed + second.cycles_computed, 2 * cycles + 2 * cycles_per_step);
}

TEST_F(Checkpoints, WhatIsNoCheckpointOfTheJobIsRefused) {
  start_worker();
  bool changed = false;
  site.bus.on_sample([&](const Envelope& envelope) {
    const auto* checkpoint = envelope.get<messaging::Checkpoint>();
    if (checkpoint != nullptr) {
      // The bus shows what is written; a hostile worker could have written it.
      auto* state = const_cast<messaging::Checkpoint*>(checkpoint);
      state->state.at(state->state.size() / 2) ^= 1;
      changed = true;
    }
    return Fate::deliver;
  });
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_TRUE(changed);
  idl::Request request;
  request.mutable_metrics();
  const auto page = site.ask(request).metrics().text();
  EXPECT_NE(page.find("lamprey_checkpoints_total{verdict=\"stored\"} 0"), std::string::npos) << page;
  EXPECT_EQ(page.find("lamprey_checkpoints_total{verdict=\"refused\"} 0"), std::string::npos);
}

TEST_F(Checkpoints, TheTraceOfARunningJobCanBeSeen) {
  start_worker();
  ASSERT_TRUE(site.run_until([&] { return stored_cycle() >= 200; }));
  idl::Request request;
  request.mutable_trace()->set_sweep("long");
  request.mutable_trace()->set_job(site.number("SELECT job FROM checkpoint"));
  const auto running = site.ask(request).trace();
  EXPECT_EQ(running.state(), "running");
  EXPECT_GE(running.cycle(), 200U);
  EXPECT_EQ(running.cycles(), cycles);
  ASSERT_TRUE(site.run_to_end());
  const auto ended = site.ask(request).trace();
  EXPECT_EQ(ended.state(), "done");
  ASSERT_GE(ended.rows_size(), running.rows_size());
  for (int i = 0; i < running.rows_size(); ++i) {
    EXPECT_EQ(running.rows(i).SerializeAsString(), ended.rows(i).SerializeAsString());
  }
  request.mutable_trace()->set_first_row(1);
  EXPECT_EQ(site.ask(request).trace().rows_size(), ended.rows_size() - 1);
}

}  // namespace
}  // namespace lamprey::tests
