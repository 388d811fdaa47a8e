#include "messaging/cyclonedds/configuration.hpp"

#include "messaging/names.hpp"
#include "messaging/tuning.hpp"

#include <cstdlib>
#include <stdexcept>

namespace lamprey::messaging::cyclonedds {
namespace {

bool uses_multicast(const JoinOptions& options) {
  return !options.loopback_only && options.peers.empty();
}

/// To announce itself, and not to listen (JoinOptions::one_of_many).
bool only_announces(const JoinOptions& options) {
  return options.one_of_many && uses_multicast(options);
}

std::string discovery_peers(const JoinOptions& options) {
  std::string xml;
  if (only_announces(options)) {
    xml += "<Peer address=\"" + std::string(announcement_group) + ":" +
           std::to_string(announcement_port(options.domain)) + "\"/>";
  }
  if (options.loopback_only) xml += "<Peer address=\"127.0.0.1\"/>";
  for (const auto& peer : options.peers) {
    // Also keeps anything that means something in XML out of the configuration.
    if (!is_valid_peer(peer)) throw std::runtime_error("peer '" + peer + "' is not a host name or address");
    xml += "<Peer address=\"" + peer + "\"/>";
  }
  return xml.empty() ? xml : "<Peers>" + xml + "</Peers>";
}

/// Which are used, where that is said. Programs of this machine meet over them, too.
std::string interfaces(const JoinOptions& options) {
  std::string xml;
  if (options.loopback_only) xml += "<NetworkInterface address=\"127.0.0.1\" multicast=\"false\"/>";
  for (const auto& address : options.interfaces) xml += "<NetworkInterface address=\"" + address + "\"/>";
  return xml.empty() ? xml : "<Interfaces>" + xml + "</Interfaces>";
}

/// A socket of a multicast port gets what any program of the host has asked for (Linux, IP_MULTICAST_ALL), so it is not
/// enough to join no group: who only announces itself has its multicast sockets on two ports that RTPS leaves free.
/// And `ssm`, without which no socket could send to a group, is the kind of multicast that nobody here receives.
std::string multicast(const JoinOptions& options) {
  if (!uses_multicast(options)) return "<AllowMulticast>false</AllowMulticast>";
  return only_announces(options) ? "<AllowMulticast>ssm</AllowMulticast>" : "";
}
std::string ports(const JoinOptions& options) {
  if (!only_announces(options)) return "";
  return "<Ports><MulticastMetaOffset>2</MulticastMetaOffset><MulticastDataOffset>3</MulticastDataOffset></Ports>";
}

/// Where others find the program by its host's address: ports of its own, so that each program of a host has some; by
/// default ten can. On loopback everybody announces himself to each of these ports, and who is not to listen has
/// others.
std::string participant_index(const JoinOptions& options) {
  if (options.one_of_many && options.loopback_only) return "<ParticipantIndex>none</ParticipantIndex>";
  return "<ParticipantIndex>auto</ParticipantIndex>";
}

}  // namespace

// What is not set here and matters all the same: the watermarks of what a writer has sent and nobody has acknowledged
// (30 kB, growing to 500 kB while nothing is lost) stay Cyclone's. They keep a writer from overrunning the receive
// buffers, and are what a keep-all writer is full at long before it holds as many samples as its profile says, if the
// samples are large: one dead reader then holds it up until the participant's lease ends. Qualities of service, topic
// by topic, are in endpoints.hpp.
std::string configuration(const JoinOptions& options, std::optional<std::uint32_t> external_domain,
                          KeyHashes key_hashes) {
  if (!options.discovery_servers.empty()) {
    throw std::runtime_error(
        "Cyclone DDS has no discovery server: name a peer instead, or take Fast DDS (--dds fastdds)");
  }
  std::string general = interfaces(options);
  // One frame of a network each (tuning.hpp). On loopback nothing is lost on the way, and large datagrams cost less.
  if (!options.loopback_only) {
    general += "<MaxMessageSize>" + std::to_string(maximum_message_bytes) + "B</MaxMessageSize>";
    general += "<FragmentSize>" + std::to_string(maximum_fragment_bytes) + "B</FragmentSize>";
  }
  general += multicast(options);

  std::string discovery = discovery_peers(options) + ports(options) + participant_index(options);
  discovery += "<MaxAutoParticipantIndex>" + std::to_string(participants_per_host - 1) + "</MaxAutoParticipantIndex>";
  discovery += "<LeaseDuration>" + std::to_string(participant_lease.count()) + "s</LeaseDuration>";
  discovery += "<SPDPInterval>" + std::to_string(announcement_period.count()) + "s</SPDPInterval>";
  if (external_domain) discovery += "<ExternalDomainId>" + std::to_string(*external_domain) + "</ExternalDomainId>";

  // `max` asks for this much and is content with less; `min` would refuse to start where the system allows less.
  std::string internal = "<SocketReceiveBufferSize max=\"" + std::to_string(socket_receive_buffer_bytes) + "B\"/>";
  // By default 100 ms, of which a reader that has just been found waits for two before it gets its first sample.
  internal += "<HeartbeatInterval>20ms</HeartbeatInterval>";
  // Fast DDS 2.9 drops keys of more than 16 octets unread, those of discovery among them: without their hashes it does
  // not notice that a writer, a reader or a whole program has left until the program's lease ends.
  if (key_hashes == KeyHashes::sent) internal += "<GenerateKeyhash>true</GenerateKeyhash>";

  std::string text = "<CycloneDDS><Domain Id=\"any\"><General>" + general + "</General><Discovery>" + discovery +
                     "</Discovery><Internal>" + internal + "</Internal></Domain></CycloneDDS>";
  if (const char* users = std::getenv("CYCLONEDDS_URI"); users != nullptr && *users != '\0') {
    text += ",";
    text += users;
  }
  return text;
}

}  // namespace lamprey::messaging::cyclonedds
