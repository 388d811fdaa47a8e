#include "messaging/network_interfaces.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <vector>

namespace lamprey::messaging {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const NetworkInterface loopback{"lo", "127.0.0.1", true, false};
const NetworkInterface wire{"eth0", "192.0.2.7", false, true};
const NetworkInterface second_address{"eth0", "192.0.2.8", false, true};
const NetworkInterface tunnel{"tun0", "10.0.0.1", false, false};
const std::vector<NetworkInterface> existing{loopback, wire, second_address, tunnel};

std::string error_of(const std::vector<std::string>& chosen, const std::vector<NetworkInterface>& interfaces) {
  try {
    addresses_of(chosen, interfaces);
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(NetworkInterfaces, OfThisMachineIncludeLoopback) {
  const auto interfaces = network_interfaces();
  const auto found = std::ranges::find(interfaces, "127.0.0.1", &NetworkInterface::address);
  ASSERT_NE(found, interfaces.end());
  EXPECT_TRUE(found->loopback);
}

TEST(NetworkInterfaces, AreMeantByNameOrAddress) {
  EXPECT_TRUE(is_among(wire, {"tun0", "eth0"}));
  EXPECT_TRUE(is_among(wire, {"192.0.2.7"}));
  EXPECT_FALSE(is_among(wire, {"192.0.2.8", "tun0"}));
  EXPECT_FALSE(is_among(wire, {}));
}

TEST(NetworkInterfaces, BecomeAddressesEachOnceInTheOrderOfTheChoice) {
  EXPECT_THAT(addresses_of({"tun0", "eth0", "192.0.2.7"}, existing), ElementsAre("10.0.0.1", "192.0.2.7", "192.0.2.8"));
  EXPECT_THAT(addresses_of({}, existing), IsEmpty());
}

TEST(NetworkInterfaces, ThatAreNotThereAreAnsweredWithThoseThatAre) {
  EXPECT_THAT(error_of({"eth0", "eth1"}, existing),
              AllOf(HasSubstr("'eth1'"), HasSubstr("there are: eth0 (192.0.2.7), eth0 (192.0.2.8), tun0 (10.0.0.1)"),
                    Not(HasSubstr("127.0.0.1"))));
  EXPECT_THAT(error_of({"eth0"}, {loopback}), HasSubstr("there is none but loopback"));
}

TEST(NetworkInterfaces, LoopbackIsNoChoiceSinceAnOptionSaysIt) {
  EXPECT_THAT(error_of({"lo"}, existing), AllOf(HasSubstr("'lo'"), HasSubstr("--loopback-only")));
  EXPECT_THAT(error_of({"127.0.0.1"}, existing), HasSubstr("--loopback-only"));
}

TEST(NetworkInterfaces, AreAtMostAsManyAsBothVendorsTake) {
  std::vector<NetworkInterface> many;
  for (int number = 1; number <= 5; ++number) {
    many.push_back({"eth0", "192.0.2." + std::to_string(number), false, true});
  }
  EXPECT_THAT(error_of({"eth0"}, many), AllOf(HasSubstr("5 IPv4 addresses"), HasSubstr("at most 4")));
  many.pop_back();
  EXPECT_EQ(addresses_of({"eth0"}, many).size(), most_interfaces);
}

}  // namespace
}  // namespace lamprey::messaging
