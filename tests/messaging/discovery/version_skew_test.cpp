#include "messaging/discovery/version_skew.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::messaging::discovery {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Introduction own{
    .role = "coordinator", .host = "alpha", .process = 1, .build = "0.1.0", .isolation = "lab", .wire = 4};

Introduction worker(std::uint32_t wire, const std::string& build) {
  return {.role = "worker", .host = "beta", .process = 4711, .build = build, .isolation = "lab", .wire = wire};
}

Participant participant(std::optional<Introduction> introduction) {
  return {.guid = {1}, .name = "", .introduction = std::move(introduction)};
}

TEST(VersionSkew, IsNoneAmongEquals) {
  EXPECT_THAT(version_skew({participant(worker(4, "0.1.0")), participant(std::nullopt)}, own), IsEmpty());
}

TEST(VersionSkew, OfOtherIsolationsIsTheirOwnAffair) {
  auto stranger = worker(5, "0.2.0");
  stranger.isolation = "elsewhere";
  EXPECT_THAT(version_skew({participant(stranger)}, own), IsEmpty());
}

TEST(VersionSkew, ToldOncePerProgram) {
  const auto newer = participant(worker(5, "0.2.0"));
  EXPECT_THAT(version_skew({newer, newer}, own), ElementsAre(VersionSkew{worker(5, "0.2.0"), false}));
}

TEST(VersionSkew, SaysWhatComesOfIt) {
  EXPECT_EQ(to_text({worker(5, "0.2.0"), false}, own),
            "worker beta/4711 (0.2.0) speaks lamprey/5, and this program lamprey/4: they never meet; install the same "
            "version everywhere");
  EXPECT_EQ(to_text({worker(4, "0.1.1"), true}, own),
            "worker beta/4711 (0.1.1) is of another build than this program (0.1.0); they understand each other");
}

}  // namespace
}  // namespace lamprey::messaging::discovery
