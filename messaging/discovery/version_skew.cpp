#include "messaging/discovery/version_skew.hpp"

#include <algorithm>

namespace lamprey::messaging::discovery {
namespace {

std::string wire_of(const Introduction& program) {
  return "lamprey/" + std::to_string(program.wire);
}

}  // namespace

std::vector<VersionSkew> version_skew(const std::vector<Participant>& others, const Introduction& own) {
  std::vector<VersionSkew> found;
  for (const auto& other : others) {
    if (!other.introduction || other.introduction->isolation != own.isolation) continue;
    const auto& who = *other.introduction;
    if (who.wire == own.wire && who.build == own.build) continue;
    VersionSkew skew{.who = who, .meets = who.wire == own.wire};
    if (std::ranges::find(found, skew) == found.end()) found.push_back(std::move(skew));
  }
  return found;
}

std::string to_text(const VersionSkew& skew, const Introduction& own) {
  const auto& who = skew.who;
  std::string text = who.role + " " + who.host + "/" + std::to_string(who.process) + " (" + who.build + ")";
  if (skew.meets)
    return text + " is of another build than this program (" + own.build + "); they understand each other";
  return text + " speaks " + wire_of(who) + ", and this program " + wire_of(own) +
         ": they never meet; install the same version everywhere";
}

}  // namespace lamprey::messaging::discovery
