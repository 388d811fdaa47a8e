// Each hole that the lease protocol closes: the test drops, repeats, delays or reorders exactly that sample, and the
// sweep still ends with every job once and the digests of a quiet day.
#include "messaging/fragmentation.hpp"
#include "tests/coordinator/site.hpp"

#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <set>
#include <string_view>

namespace lamprey::tests {
namespace {

using messaging::Lease;
using messaging::LeaseKind;
using messaging::ResultAcknowledgement;
using messaging::ResultBatch;
using messaging::SweepSpecification;
using messaging::WorkerStatus;

/// Applies `fate` to the samples of a type that `chosen` picks, at most `most` of them, and counts.
template <class Sample>
class Fault {
 public:
  Fault(
      Site& site, Fate fate, int most, std::function<bool(const Sample&)> chosen = [](const Sample&) { return true; })
      : count_(std::make_shared<int>(0)) {
    site.bus.on_sample([count = count_, fate, most, chosen](const Envelope& envelope) {
      const auto* sample = envelope.get<Sample>();
      if (sample == nullptr || *count >= most || !chosen(*sample)) return Fate::deliver;
      ++*count;
      return fate;
    });
  }
  int fired() const { return *count_; }

 private:
  std::shared_ptr<int> count_;
};

bool is_grant(const Lease& lease) {
  return lease.kind == LeaseKind::grant;
}

class ProtocolFaults : public testing::Test {
 protected:
  void start(std::size_t workers = 2) {
    site.start_coordinator();
    for (std::size_t i = 0; i < workers; ++i) site.start_worker();
  }
  Site site;
};

TEST_F(ProtocolFaults, NothingGoesWrong) {
  start();
  site.submit(small_sweep("quiet"));
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(site.computed(), 96U) << "no job is computed twice on a quiet day";
}

TEST_F(ProtocolFaults, LostGrantIsSentAgainUnderTheSameId) {
  start();
  std::map<std::uint64_t, int> grants;
  int dropped = 0;
  site.bus.on_sample([&](const Envelope& envelope) {
    const auto* lease = envelope.get<Lease>();
    if (lease == nullptr || !is_grant(*lease)) return Fate::deliver;
    ++grants[lease->lease];
    return dropped++ < 3 ? Fate::drop : Fate::deliver;
  });
  site.submit(small_sweep("lost-grant"));
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_GE(dropped, 3);
  EXPECT_TRUE(std::ranges::any_of(grants, [](const auto& grant) { return grant.second > 1; }));
  EXPECT_EQ(site.computed(), 96U);
}

TEST_F(ProtocolFaults, GrantThatNeverArrivesIsGivenUpAndItsJobsGranted) {
  start(1);
  std::set<std::uint64_t> doomed;
  site.bus.on_sample([&](const Envelope& envelope) {
    const auto* lease = envelope.get<Lease>();
    if (lease == nullptr || !is_grant(*lease)) return Fate::deliver;
    if (doomed.empty()) doomed.insert(lease->lease);
    return doomed.contains(lease->lease) ? Fate::drop : Fate::deliver;
  });
  site.submit(small_sweep("doomed-grant"));
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
}

TEST_F(ProtocolFaults, RepeatedGrantsAreComputedOnce) {
  start();
  const Fault<Lease> fault(site, Fate::duplicate, 1000, is_grant);
  site.submit(small_sweep("double-grant"));
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_GT(fault.fired(), 0);
  EXPECT_EQ(site.computed(), 96U);
}

TEST_F(ProtocolFaults, LateGrantAfterItsJobsHaveEndedIsRevoked) {
  start();
  const Fault<Lease> fault(site, Fate::hold, 2, is_grant);
  site.submit(small_sweep("late-grant"));
  ASSERT_TRUE(site.run_to_end());
  site.bus.release_all();
  site.advance(std::chrono::seconds{5});
  site.expect_complete();
  EXPECT_EQ(fault.fired(), 2);
  for (std::size_t i = 0; i < site.workers(); ++i) EXPECT_EQ(site.worker(i).worker->results_held(), 0U);
}

TEST_F(ProtocolFaults, LostResultsAreSentAgain) {
  start();
  const Fault<ResultBatch> fault(site, Fate::drop, 4);
  site.submit(small_sweep("lost-results"));
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(fault.fired(), 4);
  EXPECT_EQ(site.computed(), 96U);
}

TEST_F(ProtocolFaults, RepeatedResultsAreOneRow) {
  start();
  const Fault<ResultBatch> fault(site, Fate::duplicate, 1000);
  site.submit(small_sweep("double-results"));
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_GT(fault.fired(), 4);
}

TEST_F(ProtocolFaults, LateResultsAfterTheSweepHasEndedAreDuplicates) {
  start();
  const Fault<ResultBatch> fault(site, Fate::hold, 3);
  site.submit(small_sweep("late-results"));
  ASSERT_TRUE(site.run_to_end());
  site.bus.release_all();
  site.advance(std::chrono::seconds{1});
  site.expect_complete();
  EXPECT_EQ(fault.fired(), 3);
}

TEST_F(ProtocolFaults, LostAcknowledgementIsAnsweredAgainAsDuplicate) {
  start();
  int dropped = 0;
  int duplicates = 0;
  site.bus.on_sample([&](const Envelope& envelope) {
    const auto* sample = envelope.get<ResultAcknowledgement>();
    if (sample == nullptr) return Fate::deliver;
    for (const auto& answer : sample->results) duplicates += answer.verdict == messaging::Verdict::duplicate;
    return dropped++ < 3 ? Fate::drop : Fate::deliver;
  });
  site.submit(small_sweep("lost-acknowledgement"));
  ASSERT_TRUE(site.run_to_end());
  ASSERT_TRUE(site.run_until(
      [&] { return site.worker(0).worker->results_held() + site.worker(1).worker->results_held() == 0; }));
  site.expect_complete();
  EXPECT_GT(duplicates, 0);
  EXPECT_EQ(site.computed(), 96U);
}

TEST_F(ProtocolFaults, AJobThatIsGivenBackIsLeasedAnew) {
  start();
  std::set<std::uint64_t> given_back;
  for (std::size_t worker = 0; worker < 2; ++worker) {
    site.worker(worker).executor->gives_back = [&](const worker::Task& task) {
      return task.job % 10 == 0 && given_back.insert(task.job).second;
    };
  }
  site.submit(small_sweep("given-back"));
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(given_back.size(), 10U);
  EXPECT_EQ(site.number("SELECT count(*) FROM attempt"), 0U) << "nobody has failed";
}

TEST_F(ProtocolFaults, LostSpecificationIsRepeated) {
  site.coordinator_options.newcomers_interval = site.coordinator_options.specification_interval =
      std::chrono::seconds{5};
  start();
  site.advance(std::chrono::milliseconds{500});  // the workers are no newcomers any more
  const Fault<SweepSpecification> fault(site, Fate::drop, 1);
  site.submit(small_sweep("lost-specification"));
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(fault.fired(), 1);
}

TEST_F(ProtocolFaults, SpecificationThatComesAfterTheLeaseIsWaitedFor) {
  site.coordinator_options.newcomers_interval = site.coordinator_options.specification_interval =
      std::chrono::seconds{5};
  start();
  site.advance(std::chrono::milliseconds{500});  // the workers are no newcomers any more
  const Fault<SweepSpecification> fault(site, Fate::hold, 1);
  site.submit(small_sweep("late-specification"));
  site.advance(std::chrono::milliseconds{500});
  EXPECT_EQ(site.rows(), 0U);
  site.bus.release_all();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(site.computed(), 96U);
}

TEST_F(ProtocolFaults, AFewLostHeartbeatsCostNothing) {
  start();
  site.submit(small_sweep("lost-heartbeats", 400));
  const Fault<WorkerStatus> fault(site, Fate::drop, 12);
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(fault.fired(), 12);
  EXPECT_EQ(site.computed(), 400U);
}

TEST_F(ProtocolFaults, HeartbeatsOutOfOrderSayNothingAboutNow) {
  start();
  site.submit(small_sweep("old-heartbeats", 400));
  Fault<WorkerStatus> fault(site, Fate::hold, 4);
  site.advance(std::chrono::milliseconds{200});
  site.bus.on_sample({});
  site.advance(std::chrono::milliseconds{200});
  site.bus.release_all();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_GT(fault.fired(), 0);
  EXPECT_EQ(site.computed(), 400U);
}

TEST_F(ProtocolFaults, WorkersMayStartFirst) {
  site.start_worker();
  site.start_worker();
  site.advance(std::chrono::seconds{10});
  site.start_coordinator();
  site.submit(small_sweep("workers-first"));
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
}

TEST_F(ProtocolFaults, KilledCoordinatorFindsItsLeasesAgain) {
  start();
  site.submit(small_sweep("restart", 400));
  ASSERT_TRUE(site.run_until([&] { return site.rows() > 40; }));
  site.kill_coordinator();
  const auto before = site.computed();
  site.advance(std::chrono::seconds{2});
  EXPECT_GT(site.computed(), before) << "workers finish what they hold without a coordinator";
  site.start_coordinator();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(site.computed(), 400U) << "leases that workers hold are adopted, not granted anew";
  EXPECT_EQ(site.number("SELECT epoch FROM database"), 2U);
}

TEST_F(ProtocolFaults, CoordinatorKilledBetweenCommitAndAcknowledgement) {
  start();
  const Fault<ResultAcknowledgement> fault(site, Fate::drop, 1000);
  site.submit(small_sweep("unsaid"));
  ASSERT_TRUE(site.run_until([&] { return fault.fired() > 0; }));
  site.kill_coordinator();
  site.bus.on_sample({});
  site.start_coordinator();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(site.computed(), 96U);
}

TEST_F(ProtocolFaults, CoordinatorKilledAgainAndAgain) {
  start(3);
  site.submit(small_sweep("unlucky", 400));
  for (int i = 0; i < 8; ++i) {
    site.advance(std::chrono::milliseconds{300 + 100 * i});
    site.kill_coordinator();
    site.advance(std::chrono::milliseconds{200});
    site.start_coordinator();
  }
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
}

TEST_F(ProtocolFaults, GrantOfADeadCoordinatorIsIgnored) {
  start();
  site.submit(small_sweep("stale"));
  Fault<Lease> fault(site, Fate::hold, 2, is_grant);
  ASSERT_TRUE(site.run_until([&] { return fault.fired() == 2; }));
  site.kill_coordinator();
  site.bus.on_sample({});
  site.start_coordinator();
  ASSERT_TRUE(site.run_until([&] { return site.rows() > 8; }));
  site.bus.release_all();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(site.computed(), 96U);
}

TEST_F(ProtocolFaults, KilledWorkerLosesNothing) {
  start();
  site.submit(small_sweep("killed-worker", 400));
  ASSERT_TRUE(site.run_until([&] { return site.rows() > 100; }));
  site.kill_worker(0);
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_GE(site.number("SELECT count(*) FROM event WHERE kind = 'worker_lost'"), 1U);
}

TEST_F(ProtocolFaults, WorkerThatWasThoughtDeadBringsItsResults) {
  start();
  site.submit(small_sweep("cut-off", 400));
  ASSERT_TRUE(site.run_until([&] { return site.rows() > 100; }));
  site.bus.disconnect(site.worker(0).name);
  site.advance(std::chrono::seconds{12});
  site.bus.reconnect(site.worker(0).name);
  ASSERT_TRUE(site.run_to_end());
  ASSERT_TRUE(site.run_until([&] { return site.worker(0).worker->results_held() == 0; }));
  site.expect_complete();
}

TEST_F(ProtocolFaults, WhatWasSentIntoALongCutIsSentAgainAsSoonAsItIsOver) {
  start();
  site.submit(small_sweep("long-cut", 4000));
  ASSERT_TRUE(site.run_until([&] { return site.rows() > 100; }));
  site.bus.disconnect(site.worker(0).name);
  site.advance(std::chrono::seconds{30});
  ASSERT_GT(site.worker(0).worker->results_held(), 0U) << "by now sent again every 16 s";
  site.bus.reconnect(site.worker(0).name);
  EXPECT_TRUE(site.run_until([&] { return site.worker(0).worker->results_held() == 0; }, std::chrono::seconds{2}));
}

TEST_F(ProtocolFaults, LeavingWorkerGivesItsLeasesBackAtOnce) {
  start();
  site.submit(small_sweep("leaver", 400));
  ASSERT_TRUE(site.run_until([&] { return site.rows() > 60; }));
  auto& leaver = *site.worker(0).worker;
  leaver.begin_leaving(site.now);
  ASSERT_TRUE(site.run_until([&] { return leaver.settled(); }));
  leaver.goodbye(site.now);
  site.advance(std::chrono::milliseconds{100});
  site.kill_worker(0);
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(site.number("SELECT count(*) FROM event WHERE kind = 'lease_lost'"), 0U);
  EXPECT_EQ(site.computed(), 400U);
}

TEST_F(ProtocolFaults, WorkerWithoutCoordinatorStopsAtItsBoundAndGoesOn) {
  site.outbox_options.most_bytes = 4'000;
  start(1);
  site.submit(small_sweep("bounded", 400));
  ASSERT_TRUE(site.run_until([&] { return site.rows() > 40; }));
  site.kill_coordinator();
  site.advance(std::chrono::seconds{30});
  const auto computed = site.computed();
  site.advance(std::chrono::seconds{30});
  EXPECT_EQ(site.computed(), computed) << "it waits";
  EXPECT_GT(site.worker(0).worker->results_held(), 0U);
  site.start_coordinator();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_EQ(site.computed(), 400U);
}

TEST_F(ProtocolFaults, LongOutcomesTravelInFragmentsInAnyOrder) {
  start();
  int fragments = 0;
  site.bus.on_sample([&](const Envelope& envelope) {
    const auto* batch = envelope.get<ResultBatch>();
    if (batch == nullptr || batch->results.front().fragments == 1) return Fate::deliver;
    switch (++fragments) {
      case 1:
        return Fate::hold;
      case 2:
        return Fate::duplicate;
      case 4:
        return Fate::drop;
      default:
        return Fate::deliver;
    }
  });
  site.submit(
      "name: long\nbase: {mutation: one, acceptance: annealing, cycles: 12000, temperature: 1000.0}\nreplicates: 2\n");
  ASSERT_TRUE(site.run_until([&] { return fragments > 4; }));
  site.bus.release_all();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_GT(site.number("SELECT max(accepted) FROM job"), 4'000U);
}

TEST_F(ProtocolFaults, JobThatKillsItsWorkersIsQuarantinedAndTheRestIsDone) {
  site.start_coordinator();
  site.submit(small_sweep("poison", 48));
  const auto poison = [](const worker::Task& task) {
    if (task.job == 17) throw SteppedExecutor::WorkerDied{};
  };
  ASSERT_TRUE(site.run_until(
      [&] {
        while (site.workers() < 2) site.start_worker().executor->before_job = poison;
        return site.ended();
      },
      std::chrono::seconds{600}));
  EXPECT_EQ(site.rows("state = 'done'"), 47U);
  EXPECT_EQ(site.rows("state = 'quarantined' AND job = 17 AND attempt = 3"), 1U);
}

TEST_F(ProtocolFaults, UnreadableSpecificationIsLeftToOtherWorkers) {
  start(1);
  // What a coordinator of a later version might send: this worker can't read it, the next one can.
  site.bus.on_sample([](const Envelope& envelope) {
    const auto* sample = envelope.get<SweepSpecification>();
    return sample != nullptr && sample->open ? Fate::drop : Fate::deliver;
  });
  site.submit(small_sweep("later-version"));
  {
    const auto stranger = site.bus.join("later coordinator");
    const auto writer = stranger->writer<SweepSpecification>();
    SweepSpecification sample;
    sample.origin = {site.database_id(), 1, 0, experiment::science_version};
    sample.sweep = experiment::sweep_id(experiment::parse_sweep(small_sweep("later-version"), "test").specification);
    sample.name = "later-version";
    sample.specification = {0xff, 0xff, 0xff};
    site.bus.on_sample({});
    ASSERT_TRUE(static_cast<bool>(writer->write(sample)));
  }
  site.advance(std::chrono::milliseconds{200});
  site.start_worker();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
}

TEST_F(ProtocolFaults, RandomLossRepetitionAndDelayOfEverything) {
  const char* size = std::getenv("LAMPREY_TEST_SIZE");
  const unsigned storms = size != nullptr && std::string_view(size) == "full" ? 60 : 6;
  for (unsigned seed = 1; seed <= storms; ++seed) {
    Site stormy;
    stormy.start_coordinator();
    for (int i = 0; i < 3; ++i) stormy.start_worker();
    stormy.submit(small_sweep("storm", 200));
    std::mt19937 random(seed);
    int faults = 0;
    stormy.bus.on_sample([&](const Envelope&) {
      const auto draw = random() % 100;
      if (draw >= 30) return Fate::deliver;
      ++faults;
      return draw < 10 ? Fate::drop : draw < 20 ? Fate::duplicate : Fate::hold;
    });
    ASSERT_TRUE(stormy.run_until(
        [&] {
          const auto held = stormy.bus.held();
          if (!held.empty() && random() % 4 == 0) stormy.bus.release(held[random() % held.size()]);
          return stormy.ended();
        },
        std::chrono::seconds{900}))
        << "seed " << seed;
    EXPECT_GT(faults, 20);
    stormy.expect_complete();
  }
}

}  // namespace
}  // namespace lamprey::tests
