#include "messaging/discovery/mismatches.hpp"
#include "messaging/discovery/watch.hpp"
#include "messaging/qos.hpp"
#include "tests/conformance/world.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <thread>

namespace lamprey::messaging::conformance {
namespace {

using discovery::DomainView;
using ::testing::ElementsAre;

/// The reading side of the pair watches what the writing side does.
class Discovery : public World {
 protected:
  /// Looks until it is so.
  DomainView look_until(discovery::Watch& watch, const std::function<bool(const DomainView&)>& enough) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    DomainView view = watch.look();
    while (!enough(view)) {
      if (std::chrono::steady_clock::now() > deadline) {
        ADD_FAILURE() << "discovery has not told";
        break;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      view = watch.look();
    }
    return view;
  }

  /// Only what is of this test's isolation: other tests may run in the same domain.
  bool is_mine(const discovery::Participant& participant) const {
    return participant.introduction && participant.introduction->isolation == writers_options().isolation;
  }
  std::vector<discovery::Participant> mine(const DomainView& view) const {
    std::vector<discovery::Participant> found;
    std::ranges::copy_if(view.participants, std::back_inserter(found), [&](const auto& one) { return is_mine(one); });
    return found;
  }
  std::vector<discovery::Endpoint> endpoints_of(const DomainView& view, const discovery::Guid& participant) const {
    std::vector<discovery::Endpoint> found;
    std::ranges::copy_if(view.endpoints, std::back_inserter(found),
                         [&](const auto& one) { return one.participant == participant; });
    return found;
  }

  JoinOptions writers_options() const {
    auto join = options(GetParam().writer, "");
    join.introduction = {.role = "worker", .host = "alpha", .process = 4711, .build = "0.1.0", .isolation = {}};
    return join;
  }
};

TEST_P(Discovery, TellsWhoIsThereWithWhatAndWhenTheyLeave) {
  const auto watch = discovery::watch(options(GetParam().reader, "-watching"));
  auto participant = join(writers_options());
  auto leases = participant->reader<Lease>(nullptr, Partition::of(3));
  auto statuses = participant->writer<WorkerStatus>();

  const auto view = look_until(*watch, [&](const DomainView& seen) {
    const auto all = mine(seen);
    return !all.empty() && endpoints_of(seen, all.front().guid).size() == 2;
  });
  const auto found = mine(view);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(discovery::vendor_of(found.front()), GetParam().writer == "fastdds" ? "Fast DDS" : "Cyclone DDS");
  auto introduction = writers_options().introduction;
  introduction.isolation = writers_options().isolation;
  introduction.wire = wire_version;
  EXPECT_EQ(found.front().introduction, introduction);

  auto endpoints = endpoints_of(view, found.front().guid);
  std::ranges::sort(endpoints, {}, &discovery::Endpoint::writes);
  EXPECT_EQ(endpoints[0].topic, Topic<Lease>::name);
  EXPECT_FALSE(endpoints[0].writes);
  EXPECT_THAT(endpoints[0].qos.partitions, ElementsAre(introduction.isolation + "/0000000000000003"));
  EXPECT_EQ(endpoints[1].topic, Topic<WorkerStatus>::name);
  EXPECT_TRUE(endpoints[1].writes);
  EXPECT_TRUE(endpoints[1].qos.reliable);
  EXPECT_EQ(endpoints[1].qos.durability, discovery::Durability::transient_local);
  EXPECT_EQ(endpoints[1].qos.liveliness_lease, Topic<WorkerStatus>::profile.liveliness);
  EXPECT_EQ(endpoints[1].qos.deadline, discovery::EndpointQos::infinite);

  statuses.reset();
  look_until(*watch, [&](const DomainView& seen) { return endpoints_of(seen, found.front().guid).size() == 1; });
  leases.reset();
  participant.reset();
  look_until(*watch, [&](const DomainView& seen) { return mine(seen).empty(); });
}

TEST_P(Discovery, TellsHowMuchAProgramHasExchanged) {
  const auto watch = discovery::watch(options(GetParam().reader, "-watching"));
  auto participant = join(writers_options());
  auto statuses = participant->writer<WorkerStatus>();
  auto own = participant->reader<WorkerStatus>(nullptr);
  auto traffic = participant->writer<Traffic>();
  ASSERT_TRUE(statuses->write(WorkerStatus{}));
  const auto guid = participant->traffic().participant;
  const auto told_of = [&](const DomainView& seen) {
    return std::ranges::find(seen.traffic, guid, &Traffic::participant);
  };
  const auto view = look_until(*watch, [&](const DomainView& seen) {
    EXPECT_TRUE(traffic->write(participant->traffic()));  // best effort: until one has arrived
    return told_of(seen) != seen.traffic.end();
  });
  const auto told = told_of(view);
  ASSERT_NE(told, view.traffic.end());
  ASSERT_FALSE(told->topics.empty());
  EXPECT_EQ(told->topics.front().topic, Topic<WorkerStatus>::name);
  EXPECT_EQ(told->topics.front().written, 1U);
  EXPECT_EQ(mine(view).size(), 1U);
  EXPECT_EQ(mine(view).front().guid, guid) << "the traffic is told under the name that discovery knows";
}

TEST_P(Discovery, TellsEachProgramOfTheOthers) {
  auto participant = join(writers_options());
  auto observer = join_reader();
  const auto is_known = [&] {
    const auto others = observer->others();
    return std::ranges::any_of(others, [&](const auto& other) { return is_mine(other); });
  };
  const auto wait_until = [&](bool known) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (is_known() != known && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return is_known() == known;
  };
  EXPECT_TRUE(wait_until(true));
  const auto own = observer->traffic().participant;
  EXPECT_TRUE(std::ranges::none_of(observer->others(), [&](const auto& other) { return other.guid == own; }));
  participant.reset();
  EXPECT_TRUE(wait_until(false));
}

// What the two vendors announce of our own topics must not look like a mismatch to either.
TEST_P(Discovery, FindsNoMismatchBetweenOurPrograms) {
  const auto watch = discovery::watch(options(GetParam().reader, "-watching"));
  auto from = join_writer();
  auto to = join_reader();
  auto status_writer = from->writer<WorkerStatus>();
  auto lease_writer = from->writer<Lease>();
  auto servo_writer = from->writer<ServoCommand>();
  auto status_reader = to->reader<WorkerStatus>(nullptr);
  auto lease_reader = to->reader<Lease>(nullptr);
  auto servo_reader = to->reader<ServoCommand>(nullptr);
  const auto ours = [&](const discovery::Endpoint& endpoint) {
    return endpoint.qos.partitions == std::vector{options("", "").isolation + "/common"};
  };
  const auto view =
      look_until(*watch, [&](const DomainView& seen) { return std::ranges::count_if(seen.endpoints, ours) == 6; });
  for (const auto& mismatch : discovery::mismatches(view)) {
    EXPECT_FALSE(ours(mismatch.writer)) << mismatch.writer.topic << ": " << mismatch.reason;
  }
}

INSTANTIATE_TEST_SUITE_P(Port, Discovery, ::testing::ValuesIn(network_pairs()), pair_name);

}  // namespace
}  // namespace lamprey::messaging::conformance
