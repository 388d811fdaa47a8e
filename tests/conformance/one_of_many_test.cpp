#include "messaging/qos.hpp"
#include "tests/conformance/world.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <thread>

namespace lamprey::messaging::conformance {
namespace {

/// The writing side is one of many alike (JoinOptions::one_of_many), the reading side is not.
class OneOfMany : public World {
 protected:
  std::unique_ptr<Participant> join_as(const std::string& vendor, const std::string& role, bool one_of_many) {
    auto join = options(vendor, "");
    join.one_of_many = one_of_many;
    join.introduction.role = role;
    return messaging::join(join);
  }
  std::unique_ptr<Participant> join_one() { return join_as(GetParam().writer, "one", true); }
  std::unique_ptr<Participant> join_listener() { return join_as(GetParam().reader, "listener", false); }

  /// How many of this test's programs of that role the participant knows.
  std::ptrdiff_t known(Participant& participant, const std::string& role) {
    return std::ranges::count_if(participant.others(), [&](const discovery::Participant& other) {
      return other.introduction && other.introduction->isolation == options("", "").isolation &&
             other.introduction->role == role;
    });
  }
  void wait_until(const std::function<bool()>& condition) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!condition()) {
      ASSERT_LT(std::chrono::steady_clock::now(), deadline);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  /// In both directions.
  void exchange(Participant& one, Participant& listener) {
    const auto status_writer = one.writer<WorkerStatus>();
    Inbox<WorkerStatus> statuses(listener);
    const auto lease_writer = listener.writer<Lease>(Partition::of(7));
    Inbox<Lease> leases(one, Partition::of(7));
    WorkerStatus status;
    status.origin.worker = 7;
    meet(*status_writer, statuses, status);
    Lease lease;
    lease.lease = 8;
    meet(*lease_writer, leases, lease);
  }
};

TEST_P(OneOfMany, MeetsWhoListensAlready) {
  const auto listener = join_listener();
  const auto one = join_one();
  exchange(*one, *listener);
}

TEST_P(OneOfMany, MeetsWhoListensLater) {
  const auto one = join_one();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // its first announcements, which nobody has heard
  const auto listener = join_listener();
  exchange(*one, *listener);
}

INSTANTIATE_TEST_SUITE_P(Port, OneOfMany, ::testing::ValuesIn(network_pairs()), pair_name);
/// Found by the address of its host, as by a coordinator that names it.
INSTANTIATE_TEST_SUITE_P(ByAddress, OneOfMany, ::testing::ValuesIn(pairs_with_network_settings()), pair_name);

using ManyAlike = OneOfMany;

TEST_P(ManyAlike, DoNotFindEachOther) {
  const auto listener = join_listener();
  const auto one = join_one();
  const auto other = join_one();
  wait_until(
      [&] { return known(*listener, "one") == 2 && known(*one, "listener") == 1 && known(*other, "listener") == 1; });
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_EQ(known(*one, "one"), 0);
  EXPECT_EQ(known(*other, "one"), 0);
}

INSTANTIATE_TEST_SUITE_P(Port, ManyAlike, ::testing::ValuesIn(network_pairs()), pair_name);

}  // namespace
}  // namespace lamprey::messaging::conformance
