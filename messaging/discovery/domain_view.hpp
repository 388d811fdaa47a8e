#pragma once

#include "messaging/discovery/introduction.hpp"
#include "messaging/traffic.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What DDS discovery tells of a domain: of our programs, and of everybody else's.
namespace lamprey::messaging::discovery {

/// A participant's prefix (12 octets) and an entity's number in it (4). Section 8.2.4 of DDSI-RTPS.
using Guid = std::array<std::uint8_t, 16>;

/// 32 hex digits in groups of eight: "01100f5a.8d1c47c4.c17eb1a2.000001c1".
std::string to_text(const Guid& guid);

struct Participant {
  Guid guid{};
  std::string name;  ///< where the program has given it one
  std::optional<Introduction> introduction;
  bool operator==(const Participant&) const = default;
};

/// By the vendor's identification, which the first two octets of its GUIDs are (but for Fast DDS's discovery servers):
/// "Cyclone DDS", or "vendor 01.42" of one that is not known here.
std::string vendor_of(const Participant& participant);

enum class Durability : std::uint8_t { volatile_, transient_local, transient, persistent };
enum class Liveliness : std::uint8_t { automatic, manual_by_participant, manual_by_topic };
std::string_view to_text(Durability durability);
std::string_view to_text(Liveliness liveliness);

/// The policies by which a writer and a reader of one topic may fail to match, and their partitions.
struct EndpointQos {
  static constexpr std::chrono::nanoseconds infinite = std::chrono::nanoseconds::max();

  bool reliable = false;
  bool exclusive = false;  ///< ownership
  Durability durability = Durability::volatile_;
  Liveliness liveliness = Liveliness::automatic;
  std::chrono::nanoseconds liveliness_lease = infinite;
  std::chrono::nanoseconds deadline = infinite;
  std::vector<std::int16_t> representations;  ///< 0: XCDR1 (also where none is named), 1: XML, 2: XCDR2
  std::vector<std::string> partitions;        ///< none: the default one, ""; may hold wildcards
  bool operator==(const EndpointQos&) const = default;
};

struct Endpoint {
  Guid guid{};
  Guid participant{};
  bool writes = false;  ///< else it reads
  std::string topic;
  std::string type;
  EndpointQos qos;
  bool operator==(const Endpoint&) const = default;
};

/// Sorted by GUID. Endpoints may be known before their participant.
struct DomainView {
  std::vector<Participant> participants{};
  std::vector<Endpoint> endpoints{};
  std::vector<Traffic> traffic{};  ///< the newest of each participant that counts
};

}  // namespace lamprey::messaging::discovery
