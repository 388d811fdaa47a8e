#include "messaging/discovery/server_address.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::messaging::discovery {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(ServerAddress, HasThePortOfItsDomainUnlessOneIsSaid) {
  EXPECT_THAT(server_addresses({"a.example", "192.0.2.7:12066"}, 3),
              ElementsAre(ServerAddress{"a.example", 11814}, ServerAddress{"192.0.2.7", 12066}));
  EXPECT_THAT(server_addresses({"a.example"}, 0), ElementsAre(ServerAddress{"a.example", 11811}));
  EXPECT_THAT(server_addresses({}, 0), IsEmpty());
}

TEST(ServerAddress, TellsTheServersIdentity) {
  EXPECT_EQ((ServerAddress{"a", 11811}.identity()), 0);
  EXPECT_EQ((ServerAddress{"a", 12066}.identity()), 255);
}

TEST(ServerAddress, ThatIsNoneIsRefusedWithWhatWouldBe) {
  EXPECT_EQ(server_fault("a.example"), "");
  EXPECT_EQ(server_fault("192.0.2.7:11811"), "");
  for (const std::string_view bad : {"", ":11811", "a<b", "a b:11811"}) {
    EXPECT_THAT(server_fault(bad), HasSubstr("HOST:PORT")) << bad;
  }
  for (const std::string_view bad : {"a:", "a:11810", "a:12067", "a:-1", "a:11811x", "a:99999999999", "2001:db8::1"}) {
    EXPECT_THAT(server_fault(bad), AllOf(HasSubstr("'" + std::string(bad) + "'"), HasSubstr("11811 to 12066"))) << bad;
  }
  EXPECT_THROW(server_addresses({"a:1"}, 0), std::runtime_error);
}

TEST(ServerAddress, OfOnePortAreTakenForOneServer) {
  EXPECT_THROW(server_addresses({"a", "b:11811"}, 0), std::runtime_error);
  EXPECT_THROW(server_addresses({"a", "a"}, 0), std::runtime_error);
  EXPECT_EQ(server_addresses({"a", "b:11812"}, 0).size(), 2U);
}

TEST(ServerIdentity, IsInTheGuidOfAServerOnly) {
  Guid guid{};
  EXPECT_EQ(server_identity(guid), std::nullopt);
  const std::string_view text = "DS\x07_EPROSIMA";
  std::copy(text.begin(), text.end(), guid.begin());
  EXPECT_EQ(server_identity(guid), 7);
  EXPECT_EQ(vendor_of({.guid = guid, .name = {}, .introduction = {}}), "Fast DDS");
  guid[5] = 'x';
  EXPECT_EQ(server_identity(guid), std::nullopt);
}

}  // namespace
}  // namespace lamprey::messaging::discovery
