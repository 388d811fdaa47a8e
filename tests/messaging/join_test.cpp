#include "messaging/port.hpp"
#include "messaging/vendor_library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

namespace lamprey::messaging {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string error_of(const JoinOptions& options) {
  try {
    const auto participant = join(options);
    return "joined with " + participant->vendor();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(Join, FindsBothVendorsBesideTheProgram) {
  EXPECT_THAT(available_vendors(), ElementsAre("cyclonedds", "fastdds"));
}

TEST(Join, UnknownVendorIsAnsweredWithThoseThatExist) {
  JoinOptions options;
  options.vendor = "opensplice";
  EXPECT_THAT(error_of(options), AllOf(HasSubstr("'opensplice'"), HasSubstr("cyclonedds, fastdds")));
}

TEST(Join, VendorNameCannotLeaveTheFolder) {
  JoinOptions options;
  options.vendor = "../../tmp/evil";
  EXPECT_THAT(error_of(options), HasSubstr("no such vendor"));
}

TEST(Join, InvalidIsolationIsRefusedBeforeAnythingIsLoaded) {
  JoinOptions options;
  options.isolation = "every*";
  EXPECT_THAT(error_of(options), AllOf(HasSubstr("isolation 'every*'"), HasSubstr("letters")));
}

TEST(Join, InvalidPeerIsRefused) {
  JoinOptions options;
  options.peers = {"host\"/><Evil"};
  EXPECT_THAT(error_of(options), HasSubstr("not a host name or address"));
}

TEST(Join, DiscoveryServerIsRefusedByNameWithCyclone) {
  JoinOptions options;
  options.discovery_servers = {"127.0.0.1"};
  EXPECT_THAT(error_of(options), AllOf(HasSubstr("Cyclone DDS has no discovery server"), HasSubstr("fastdds")));
}

TEST(Join, DiscoveryServerThatCannotBeIsRefused) {
  JoinOptions options;
  options.vendor = "fastdds";
  options.discovery_servers = {"no-such-host.invalid"};
  EXPECT_THAT(error_of(options), HasSubstr("discovery server 'no-such-host.invalid' cannot be resolved"));
  options.discovery_servers = {"127.0.0.1:80"};
  EXPECT_THAT(error_of(options), HasSubstr("11811 to 12066"));
}

class JoinEachVendor : public ::testing::TestWithParam<std::string> {};

TEST_P(JoinEachVendor, JoinsOnLoopbackAndTellsItsName) {
  JoinOptions options;
  options.vendor = GetParam();
  options.isolation = "join-test";
  options.loopback_only = true;
  EXPECT_EQ(error_of(options), "joined with " + GetParam());
  EXPECT_EQ(error_of(options), "joined with " + GetParam()) << "a second time, after the first has left";
}

TEST_P(JoinEachVendor, UnresolvablePeerIsAnErrorThatNamesTheVendor) {
  JoinOptions options;
  options.vendor = GetParam();
  options.isolation = "join-test";
  options.peers = {"no-such-host.invalid"};
  EXPECT_THAT(error_of(options), AllOf(HasSubstr("'no-such-host.invalid' cannot be resolved"), HasSubstr(GetParam())));
}

TEST_P(JoinEachVendor, InterfaceThatIsNotThereIsAnErrorThatNamesTheVendor) {
  JoinOptions options;
  options.vendor = GetParam();
  options.isolation = "join-test";
  options.interfaces = {"no-such-interface"};
  EXPECT_THAT(error_of(options), AllOf(HasSubstr("'no-such-interface'"), HasSubstr(GetParam())));
}

TEST_P(JoinEachVendor, OnThisMachineOnlyNothingElseIsHeeded) {
  JoinOptions options;
  options.vendor = GetParam();
  options.isolation = "join-test";
  options.loopback_only = true;
  options.peers = {"no-such-host.invalid"};
  options.interfaces = {"no-such-interface"};
  options.discovery_servers = {"no-such-host.invalid"};
  EXPECT_EQ(error_of(options), "joined with " + GetParam());
}

INSTANTIATE_TEST_SUITE_P(Vendors, JoinEachVendor, ::testing::Values("cyclonedds", "fastdds"),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace lamprey::messaging
