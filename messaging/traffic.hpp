#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// How many samples a participant's writers and readers have exchanged. Octets are not counted: the vendors tell them
/// for some topics only.
namespace lamprey::messaging {

struct TopicTraffic {
  std::string topic;
  std::uint64_t written = 0;
  std::uint64_t refused = 0;  ///< writes that failed, or for which a reliable reader had no room
  std::uint64_t read = 0;     ///< taken by the program, without the malformed ones
  bool operator==(const TopicTraffic&) const = default;
};

/// A program → whoever looks at the network. All counts are since the participant joined.
struct Traffic {
  std::array<std::uint8_t, 16> participant{};  ///< its GUID
  double seconds = 0;                          ///< since it joined
  std::uint64_t malformed = 0;                 ///< samples dropped because no program of ours writes such
  std::vector<TopicTraffic> topics;
  bool operator==(const Traffic&) const = default;
};

}  // namespace lamprey::messaging
