// A database that fails for a while: the coordinator waits, says so, loses nothing and goes on.
#include "tests/coordinator/hand_worker.hpp"
#include "tests/coordinator/site.hpp"
#include "tests/storage/power_cut_vfs.hpp"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::tests {
namespace {

using ::testing::HasSubstr;

class StorageFault : public testing::TestWithParam<int> {
 protected:
  storage::testing::PowerCutVfs vfs;
  Site site;

  StorageFault() { site.vfs = vfs.name(); }

  idl::StatusReply status() {
    idl::Request request;
    request.mutable_status();
    return site.ask(request).status();
  }
};

TEST_P(StorageFault, IsWaitedForAndNothingIsLost) {
  site.start_coordinator();
  site.submit(small_sweep("s"));
  site.start_worker();
  ASSERT_TRUE(site.run_until([&] { return site.rows() >= 10; }));
  vfs.fail_from(1, GetParam());
  site.advance(std::chrono::seconds{10});
  const auto rows = site.rows();
  EXPECT_LT(rows, 96U);
  site.advance(std::chrono::seconds{20});
  EXPECT_EQ(site.rows(), rows) << "nothing can be stored";
  vfs.repair();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_TRUE(status().storage_fault().empty());
  EXPECT_GE(site.number("SELECT count(*) FROM event WHERE kind = 'storage_fault'"), 1U);
  EXPECT_EQ(site.number("SELECT count(*) FROM divergence"), 0U);
}

TEST_P(StorageFault, IsToldToWhoeverAsksAndWishesAreRefused) {
  site.start_coordinator();
  site.submit(small_sweep("s"));
  site.start_worker();
  ASSERT_TRUE(site.run_until([&] { return site.rows() >= 10; }));
  vfs.fail_from(1, GetParam());
  ASSERT_TRUE(site.run_until([&] { return !status().storage_fault().empty(); }));
  EXPECT_THAT(status().storage_fault(), HasSubstr("results.db"));
  idl::Request request;
  request.mutable_control()->set_sweep("s");
  request.mutable_control()->set_action(idl::ControlRequest::PAUSE);
  EXPECT_EQ(site.ask(request).error().code(), "storage");
  vfs.repair();
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
}

TEST_P(StorageFault, OfEveryWriteInTurnLosesNothing) {
  site.start_coordinator();
  site.jobs_per_step = 1;
  site.submit(small_sweep("s", 1'000));
  site.start_worker();
  for (std::uint64_t write = 1; write <= 15; ++write) {
    vfs.fail_from(write, GetParam());
    site.advance(std::chrono::milliseconds{200});
    vfs.repair();
    site.advance(std::chrono::milliseconds{1200});
  }
  EXPECT_FALSE(site.ended()) << "the faults were meant for a sweep that runs";
  ASSERT_TRUE(site.run_to_end());
  site.expect_complete();
  EXPECT_GE(site.number("SELECT count(*) FROM event WHERE kind = 'storage_fault'"), 10U);
}

INSTANTIATE_TEST_SUITE_P(Codes, StorageFault,
                         ::testing::Values(SQLITE_FULL, SQLITE_READONLY, SQLITE_IOERR_WRITE, SQLITE_IOERR_FSYNC),
                         [](const auto& instance) {
                           switch (instance.param) {
                             case SQLITE_FULL:
                               return "Full";
                             case SQLITE_READONLY:
                               return "ReadOnly";
                             case SQLITE_IOERR_WRITE:
                               return "Write";
                             default:
                               return "Synchronize";
                           }
                         });

}  // namespace
}  // namespace lamprey::tests
