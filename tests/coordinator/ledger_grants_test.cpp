#include "coordinator/ledger.hpp"

#include <gtest/gtest.h>
#include <map>
#include <random>
#include <vector>

/// The ledger looks for something to grant only after something has happened. Whatever happens, in whatever order, that
/// must not leave a worker without what a look would have given it.
namespace lamprey::coordinator {
namespace {

using namespace std::chrono_literals;

constexpr Id128 database{1, 2};
constexpr Id128 sweeps[] = {{3, 1}, {3, 2}, {3, 3}};
constexpr std::uint64_t workers = 6;

class EventfulLedger : public testing::TestWithParam<unsigned> {
 protected:
  std::uint64_t below(std::uint64_t bound) {
    return std::uniform_int_distribution<std::uint64_t>(0, bound - 1)(random);
  }
  bool one_in(std::uint64_t many) { return below(many) == 0; }
  const Id128& some_sweep() { return sweeps[below(std::size(sweeps))]; }
  std::uint64_t some_worker() { return below(workers) + 1; }

  void note(const std::vector<Ledger::Grant>& grants) {
    for (const auto& grant : grants) held[grant.lease.lease] = grant;
  }

  /// Lists what it holds, but for leases that have not reached it.
  void beat(std::uint64_t worker) {
    messaging::WorkerStatus status;
    status.origin = {database, 1, worker, experiment::science_version};
    status.heartbeat = ++heartbeats;
    status.window = static_cast<std::uint32_t>(below(4));
    if (one_in(10)) status.state = one_in(2) ? messaging::WorkerState::leaving : messaging::WorkerState::draining;
    if (one_in(3)) status.labels = {"gpu"};
    for (const auto& [lease, grant] : held) {
      if (grant.worker == worker && !one_in(6)) {
        status.leases.push_back({database, 1, lease, grant.lease.sweep, grant.lease.ranges});
      }
    }
    if (!status.leases.empty()) {
      const auto& running = status.leases.front();
      status.running = {{running.sweep, running.remaining.front().first}};
    }
    ledger.heartbeat(status, database, now);
  }

  void end_or_refuse_a_job() {
    if (held.empty()) return;
    const auto entry = std::next(held.begin(), static_cast<std::ptrdiff_t>(below(held.size())));
    const auto& grant = entry->second;
    const auto& range = grant.lease.ranges[below(grant.lease.ranges.size())];
    const std::uint64_t job = range.first + below(range.count);
    if (one_in(8)) {
      ledger.refused(grant.lease.sweep, job, grant.worker, "its digest is not that of its values");
    } else {
      ledger.ended(grant.lease.sweep, job, grant.lease.lease, 0.2);
    }
    if (one_in(3)) held.erase(entry);
  }

  void change_a_sweep() {
    const auto& sweep = some_sweep();
    switch (below(6)) {
      case 0:
        return ledger.add_sweep(sweep, JobRanges(0, 1 + below(60)), {});
      case 1:
        ledger.pause(sweep);
        return;
      case 2:
        return ledger.resume(sweep);
      case 3:
        return ledger.set_policy(sweep,
                                 {.priority = static_cast<std::int32_t>(below(3)),
                                  .max_concurrent = below(5),
                                  .needs = one_in(3) ? std::vector<std::string>{"gpu"} : std::vector<std::string>{}});
      case 4:
        return ledger.note_checkpoint(sweep, below(60));
      default:
        if (one_in(4)) ledger.close_sweep(sweep);
    }
  }

  void happen() {
    switch (below(5)) {
      case 0:
      case 1:
        return beat(some_worker());
      case 2:
        return end_or_refuse_a_job();
      case 3:
        now += one_in(20) ? 31s : std::chrono::milliseconds{below(400)};
        ledger.expire(now);
        return;
      default:
        if (one_in(12)) {
          ledger.drain(some_worker());
        } else {
          change_a_sweep();
        }
    }
  }

  std::mt19937 random{GetParam()};
  Clock::time_point now{1h};
  Ledger ledger{LedgerOptions{}, now, false, std::uint64_t{1} << 32};
  std::map<std::uint64_t, Ledger::Grant> held;
  std::uint64_t heartbeats = 0;
};

TEST_P(EventfulLedger, OverlooksNothingThatItCouldGrant) {
  std::size_t granted = 0;
  for (int i = 0; i < 3'000; ++i) {
    happen();
    const auto grants = ledger.grant(now);
    granted += grants.size();
    note(grants);
    // A sweep that gets no jobs changes nothing, but makes the ledger look again.
    for (const auto& sweep : sweeps) ledger.add_jobs(sweep, {});
    const auto overlooked = ledger.grant(now);
    ASSERT_EQ(overlooked.size(), 0U) << "after " << i << " events";
  }
  EXPECT_GT(granted, 100U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, EventfulLedger, testing::Range(1U, 21U));

TEST(QuietLedger, GrantsAgainAtTheMomentThatAPauseIsOver) {
  Clock::time_point now{1h};
  Ledger ledger(LedgerOptions{}, now, false, std::uint64_t{1} << 32);
  ledger.add_sweep(sweeps[0], JobRanges(0, 1), {});
  messaging::WorkerStatus status;
  status.origin = {database, 1, 7, experiment::science_version};
  status.window = 1;
  const auto beat = [&] {
    ++status.heartbeat;
    now += 300ms;
    return ledger.heartbeat(status, database, now);
  };
  beat();
  const auto grants = ledger.grant(now);
  ASSERT_EQ(grants.size(), 1U);
  // Received and never listed: sent again three times, then given up for half a minute.
  status.last_lease_sequence = grants[0].lease.sequence;
  for (int i = 0; i < 20 && ledger.leased(sweeps[0]) > 0; ++i) beat();
  ASSERT_EQ(ledger.leased(sweeps[0]), 0U);
  const auto over = now + 30s;
  while (now + 300ms < over) {
    beat();
    ASSERT_TRUE(ledger.grant(now).empty());
  }
  EXPECT_TRUE(ledger.grant(over - 1ms).empty());
  EXPECT_EQ(ledger.grant(over).size(), 1U);
}

}  // namespace
}  // namespace lamprey::coordinator
