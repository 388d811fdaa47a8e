#include "messaging/discovery/mismatches.hpp"

#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::messaging::discovery {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Endpoint writer() {
  return {.guid = {1, 15}, .participant = {}, .writes = true, .topic = "t", .type = "T", .qos = {}};
}
Endpoint reader() {
  return {.guid = {1, 16}, .participant = {}, .writes = false, .topic = "t", .type = "T", .qos = {}};
}

/// Why the two don't match, after changes to what the writer offers and the reader requests.
std::string reason(const std::function<void(Endpoint&, Endpoint&)>& change) {
  auto one = writer();
  auto other = reader();
  change(one, other);
  const auto found = mismatches({{}, {one, other}});
  return found.empty() ? "" : found.front().reason;
}

TEST(Mismatches, AreNoneWhereTheWriterOffersEnough) {
  EXPECT_EQ(reason([](Endpoint&, Endpoint&) {}), "");
  EXPECT_EQ(reason([](Endpoint& offers, Endpoint&) {
              offers.qos.reliable = true;
              offers.qos.durability = Durability::transient_local;
              offers.qos.deadline = 10ms;
              offers.qos.liveliness_lease = 1s;
            }),
            "");
}

TEST(Mismatches, NameThePolicy) {
  EXPECT_EQ(reason([](Endpoint&, Endpoint& asks) { asks.qos.reliable = true; }),
            "the writer offers best effort, the reader asks for reliable");
  EXPECT_EQ(reason([](Endpoint&, Endpoint& asks) { asks.qos.durability = Durability::transient_local; }),
            "durability: the writer offers volatile, the reader asks for transient-local");
  EXPECT_EQ(reason([](Endpoint& offers, Endpoint&) { offers.qos.exclusive = true; }),
            "ownership: the writer offers exclusive, the reader asks for shared");
  EXPECT_EQ(reason([](Endpoint& offers, Endpoint& asks) {
              offers.qos.deadline = 200ms;
              asks.qos.deadline = 100ms;
            }),
            "deadline: the writer offers 200 ms, the reader asks for 100 ms");
  EXPECT_EQ(reason([](Endpoint&, Endpoint& asks) { asks.qos.liveliness_lease = 2s; }),
            "liveliness lease: the writer offers infinite, the reader asks for 2000 ms");
  EXPECT_EQ(reason([](Endpoint&, Endpoint& asks) { asks.qos.liveliness = Liveliness::manual_by_topic; }),
            "liveliness: the writer offers automatic, the reader asks for manual by topic");
  EXPECT_EQ(reason([](Endpoint& offers, Endpoint&) { offers.qos.representations = {2}; }),
            "data representation: the writer offers XCDR2, the reader asks for XCDR1");
  EXPECT_EQ(reason([](Endpoint& offers, Endpoint&) { offers.type = "U"; }),
            "the writer's type is 'U', the reader's 'T'");
}

TEST(Mismatches, AreNobodysBusinessAcrossTopicsAndPartitions) {
  const auto ask_too_much = [](Endpoint& asks) { asks.qos.reliable = true; };
  EXPECT_EQ(reason([&](Endpoint&, Endpoint& asks) {
              ask_too_much(asks);
              asks.topic = "u";
            }),
            "");
  EXPECT_EQ(reason([&](Endpoint& offers, Endpoint& asks) {
              ask_too_much(asks);
              offers.qos.partitions = {"lab/common"};
              asks.qos.partitions = {"lamprey/common"};
            }),
            "");
}

TEST(Mismatches, HeedWildcardsInPartitions) {
  EndpointQos all;
  all.partitions = {"lab/*"};
  EndpointQos one;
  one.partitions = {"lab/common", "other"};
  EXPECT_TRUE(share_a_partition(all, one));
  EXPECT_TRUE(share_a_partition(one, all));
  EXPECT_FALSE(share_a_partition(all, {})) << "the default partition is the empty name";
  EXPECT_FALSE(share_a_partition(all, all)) << "two patterns never match";
  EXPECT_TRUE(share_a_partition({}, {}));
}

TEST(OtherWireVersions, AreFoundByTheirTopics) {
  auto old = writer();
  old.topic = "lamprey/3/lease";
  auto current = writer();
  current.topic = "lamprey/4/lease";
  auto longer = writer();
  longer.topic = "lamprey/40/lease";
  EXPECT_THAT(topics_of_other_wire_versions({{}, {old, current, old, longer, writer()}}, 4),
              ElementsAre("lamprey/3/lease", "lamprey/40/lease"));
  EXPECT_THAT(topics_of_other_wire_versions({{}, {current}}, 4), IsEmpty());
}

TEST(Vendors, AreToldByTheirGuids) {
  EXPECT_EQ(vendor_of({.guid = {1, 0x0f}, .name = {}, .introduction = {}}), "Fast DDS");
  EXPECT_EQ(vendor_of({.guid = {1, 0x10}, .name = {}, .introduction = {}}), "Cyclone DDS");
  EXPECT_EQ(vendor_of({.guid = {1, 0x42}, .name = {}, .introduction = {}}), "vendor 01.42");
  EXPECT_EQ(to_text(Guid{1, 0x10, 0xfa}), "0110fa00.00000000.00000000.00000000");
}

}  // namespace
}  // namespace lamprey::messaging::discovery
