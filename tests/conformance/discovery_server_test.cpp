#include "messaging/discovery/server.hpp"
#include "messaging/discovery/server_address.hpp"
#include "messaging/discovery/watch.hpp"
#include "tests/conformance/numbered.hpp"
#include "tests/conformance/world.hpp"

#include <algorithm>
#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <random>
#include <string>
#include <thread>

namespace lamprey::messaging::conformance {
namespace {

using discovery::ServerAddress;

/// Programs of Fast DDS that know nothing but a server's place, on a port that no other test has.
class DiscoveryServer : public ::testing::Test {
 protected:
  DiscoveryServer() : isolation_("test-" + std::to_string(std::random_device{}())) {
    std::random_device random;
    for (int attempt = 0; attempt < 20 && server == nullptr; ++attempt) {
      port_ = static_cast<std::uint16_t>(ServerAddress::first_port + random() % 256);
      try {
        server = discovery::serve(server_options(), port_);
      } catch (const JoinError&) {
        // Another test may have it.
      }
    }
  }

  static JoinOptions server_options() {
    JoinOptions options;
    options.vendor = "fastdds";
    options.domain = 99;
    options.introduction.role = discovery::server_role;
    return options;
  }

  JoinOptions client_options() const {
    auto options = server_options();
    options.isolation = isolation_;
    options.discovery_servers = {"127.0.0.1:" + std::to_string(port_)};
    options.introduction = {.role = "worker", .host = "alpha", .process = 4711, .build = "0.1.0", .isolation = {}};
    return options;
  }

  std::unique_ptr<discovery::Server> server;
  std::uint16_t port_ = 0;

 private:
  std::string isolation_;
};

TEST_F(DiscoveryServer, LetsItsClientsMeet) {
  ASSERT_NE(server, nullptr);
  const auto from = join(client_options());
  const auto to = join(client_options());
  const auto writer = from->writer<Lease>();
  Inbox<Lease> inbox(*to);
  write(*writer, numbered<Lease>(1));
  EXPECT_TRUE(inbox.take_until_size(1)) << "leases are kept for late readers";
}

TEST_F(DiscoveryServer, MayBeOneOfTwoOfWhichTheOtherIsMissing) {
  ASSERT_NE(server, nullptr);
  auto options = client_options();
  const auto other = port_ == ServerAddress::last_port ? ServerAddress::first_port : port_ + 1;
  options.discovery_servers.push_back("127.0.0.1:" + std::to_string(other));
  const auto from = join(options);
  const auto to = join(options);
  const auto writer = from->writer<Lease>();
  Inbox<Lease> inbox(*to);
  write(*writer, numbered<Lease>(1));
  EXPECT_TRUE(inbox.take_until_size(1));
}

// Clients that have met need it no more.
TEST_F(DiscoveryServer, MayEndOnceAllHaveMet) {
  ASSERT_NE(server, nullptr);
  const auto from = join(client_options());
  const auto to = join(client_options());
  const auto writer = from->writer<Lease>();
  Inbox<Lease> inbox(*to);
  write(*writer, numbered<Lease>(1));
  ASSERT_TRUE(inbox.take_until_size(1));
  server.reset();
  // Longer than a client remembers a server without a sign of life.
  std::this_thread::sleep_for(discovery::server_lease + std::chrono::seconds(1));
  write(*writer, numbered<Lease>(2));
  EXPECT_TRUE(inbox.take_until([](const auto& all) { return !all.empty() && number_of(all.back()) == 2; }));
}

TEST_F(DiscoveryServer, TellsAWatchOfEverybody) {
  ASSERT_NE(server, nullptr);
  const auto program = join(client_options());
  const auto leases = program->reader<Lease>(nullptr);
  const auto watch = discovery::watch(client_options());
  const auto sees_all = [&](const discovery::DomainView& view) {
    const auto mine = std::ranges::find_if(view.participants, [&](const discovery::Participant& each) {
      return each.introduction && each.introduction->role == "worker";
    });
    const bool sees_server = std::ranges::any_of(view.participants, [&](const discovery::Participant& each) {
      return discovery::server_identity(each.guid) == (ServerAddress{{}, port_}.identity());
    });
    return sees_server && mine != view.participants.end() &&
           std::ranges::any_of(view.endpoints, [&](const auto& each) { return each.participant == mine->guid; });
  };
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (!sees_all(watch->look())) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

TEST_F(DiscoveryServer, DoesNotTakeAnotherPortThanItsOwn) {
  ASSERT_NE(server, nullptr);
  try {
    discovery::serve(server_options(), port_);
    FAIL() << "the port is taken";
  } catch (const JoinError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("UDP port " + std::to_string(port_)));
  }
}

TEST_F(DiscoveryServer, IsNoneOfCyclones) {
  auto options = server_options();
  options.vendor = "cyclonedds";
  try {
    discovery::serve(options, port_);
    FAIL() << "it has none";
  } catch (const JoinError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("Cyclone DDS has no discovery server"));
  }
}

}  // namespace
}  // namespace lamprey::messaging::conformance
