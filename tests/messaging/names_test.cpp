#include "messaging/names.hpp"

#include <gtest/gtest.h>
#include <string>

namespace lamprey::messaging {
namespace {

TEST(Names, PartitionIsIsolationAndReceiver) {
  EXPECT_EQ(partition_name("lab-1", Partition::common()), "lab-1/common");
  EXPECT_EQ(partition_name("lab-1", Partition::of(0xab)), "lab-1/00000000000000ab");
  EXPECT_EQ(partition_name("lab-1", Partition::of(~std::uint64_t{0})), "lab-1/ffffffffffffffff");
}

TEST(Names, IsolationHasNoWildcardsAndNoSeparator) {
  EXPECT_TRUE(is_valid_isolation("lamprey"));
  EXPECT_TRUE(is_valid_isolation("A-z_0.9"));
  EXPECT_TRUE(is_valid_isolation(std::string(64, 'a')));
  for (const std::string bad : {"", "a/b", "a*", "a?", "[a]", "a b", "ä", "a\n"}) {
    EXPECT_FALSE(is_valid_isolation(bad)) << bad;
  }
  EXPECT_FALSE(is_valid_isolation(std::string(65, 'a')));
}

TEST(Names, PeerHasNothingThatMeansSomethingInXml) {
  EXPECT_TRUE(is_valid_peer("coordinator.lab.example"));
  EXPECT_TRUE(is_valid_peer("192.0.2.7"));
  EXPECT_TRUE(is_valid_peer("2001:db8::1"));
  for (const std::string bad : {"", "a\"b", "<a>", "a&b", "a b", "a,b"}) EXPECT_FALSE(is_valid_peer(bad)) << bad;
}

}  // namespace
}  // namespace lamprey::messaging
