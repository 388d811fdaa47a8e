#include "messaging/cyclonedds/configuration.hpp"

#include "messaging/names.hpp"
#include "messaging/tuning.hpp"

#include <cstdlib>
#include <stdexcept>

namespace lamprey::messaging::cyclonedds {
namespace {

std::string discovery_peers(const JoinOptions& options) {
  std::string xml;
  if (options.loopback_only) xml += "<Peer address=\"127.0.0.1\"/>";
  for (const auto& peer : options.peers) {
    // Also keeps anything that means something in XML out of the configuration.
    if (!is_valid_peer(peer)) throw std::runtime_error("peer '" + peer + "' is not a host name or address");
    xml += "<Peer address=\"" + peer + "\"/>";
  }
  return xml.empty() ? xml : "<Peers>" + xml + "</Peers>";
}

}  // namespace

std::string configuration(const JoinOptions& options, std::optional<std::uint32_t> external_domain) {
  std::string general;
  if (options.loopback_only) {
    general += "<Interfaces><NetworkInterface address=\"127.0.0.1\" multicast=\"false\"/></Interfaces>";
  }
  if (options.loopback_only || !options.peers.empty()) general += "<AllowMulticast>false</AllowMulticast>";

  std::string discovery = discovery_peers(options);
  discovery += "<ParticipantIndex>auto</ParticipantIndex>";
  discovery += "<MaxAutoParticipantIndex>" + std::to_string(participants_per_host - 1) + "</MaxAutoParticipantIndex>";
  discovery += "<LeaseDuration>" + std::to_string(participant_lease.count()) + "s</LeaseDuration>";
  if (external_domain) discovery += "<ExternalDomainId>" + std::to_string(*external_domain) + "</ExternalDomainId>";

  // `max` asks for this much and is content with less; `min` would refuse to start where the system allows less.
  const std::string internal =
      "<SocketReceiveBufferSize max=\"" + std::to_string(socket_receive_buffer_bytes) + "B\"/>";

  std::string text = "<CycloneDDS><Domain Id=\"any\"><General>" + general + "</General><Discovery>" + discovery +
                     "</Discovery><Internal>" + internal + "</Internal></Domain></CycloneDDS>";
  if (const char* users = std::getenv("CYCLONEDDS_URI"); users != nullptr && *users != '\0') {
    text += ",";
    text += users;
  }
  return text;
}

}  // namespace lamprey::messaging::cyclonedds
