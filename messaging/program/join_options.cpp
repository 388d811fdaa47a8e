#include "messaging/program/join_options.hpp"

#include "messaging/names.hpp"
#include "messaging/process_identity.hpp"
#include "messaging/program/build_info.hpp"
#include "messaging/tuning.hpp"
#include "messaging/vendor_library.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string>
#include <unistd.h>

namespace lamprey::messaging::program {
namespace {

// CLI11's validators return what is wrong, or nothing.

std::string check_vendor(const std::string& vendor) {
  const auto vendors = available_vendors();
  if (std::find(vendors.begin(), vendors.end(), vendor) != vendors.end()) return {};
  std::string text = "there is no DDS vendor '" + vendor + "'; there ";
  if (vendors.empty()) return text + "is no vendor library beside this program";
  text += vendors.size() == 1 ? "is " : "are ";
  for (std::size_t i = 0; i < vendors.size(); ++i) text += (i == 0 ? "" : ", ") + vendors[i];
  return text + " (option or LAMPREY_DDS)";
}

std::string check_domain(const std::string& text) {
  std::uint32_t domain = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), domain);
  if (error == std::errc{} && end == text.data() + text.size() && domain <= highest_domain) return {};
  return "'" + text + "' is not a DDS domain: a whole number from 0 to " + std::to_string(highest_domain) +
         " (option, LAMPREY_DOMAIN or ROS_DOMAIN_ID)";
}

std::string check_isolation(const std::string& name) {
  if (is_valid_isolation(name)) return {};
  return "'" + name + "' is not an isolation: 1 to 64 letters, digits, '_', '.' or '-' (option or LAMPREY_ISOLATION)";
}

std::string check_peer(const std::string& peer) {
  if (is_valid_peer(peer)) return {};
  return "'" + peer + "' is not a host name or address (option or LAMPREY_PEERS)";
}

/// Peers have no meaning on one machine: those of the environment are left out, others are a contradiction.
void leave_peers_out(const CLI::Option& peer, JoinOptions& options) {
  if (!options.loopback_only || peer.count() == 0) return;
  const char* const value = std::getenv("LAMPREY_PEERS");
  const auto of_environment = CLI::detail::split(value == nullptr ? "" : value, ',');
  if (options.peers != of_environment) throw CLI::ExcludesError("--loopback-only", "--peer");
  options.peers.clear();
}

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

void add_join_options(CLI::App& app, JoinOptions& options) {
  const std::string group = "DDS";
  app.add_option("--dds", options.vendor, "DDS implementation: cyclonedds or fastdds; they understand each other")
      ->envname("LAMPREY_DDS")
      ->check(check_vendor)
      ->type_name("VENDOR")
      ->capture_default_str()
      ->group(group);
  app.add_option("--domain", options.domain, "DDS domain, 0 to " + std::to_string(highest_domain))
      ->envname(is_set("LAMPREY_DOMAIN") ? "LAMPREY_DOMAIN" : "ROS_DOMAIN_ID")
      ->check(check_domain)
      ->type_name("NUMBER")
      ->capture_default_str()
      ->group(group);
  app.add_option("--isolation", options.isolation, "only programs of the same isolation meet")
      ->envname("LAMPREY_ISOLATION")
      ->check(check_isolation)
      ->type_name("NAME")
      ->capture_default_str()
      ->group(group);
  const auto* const peer =
      app.add_option("--peer", options.peers,
                     "a host to look for without multicast, such as the coordinator's; repeatable, or 'HOST,HOST'")
          ->envname("LAMPREY_PEERS")
          ->delimiter(',')
          ->check(check_peer)
          ->type_name("HOST")
          ->allow_extra_args(false)
          ->group(group);
  app.add_flag("--loopback-only", options.loopback_only,
               "meet programs on this machine only; LAMPREY_PEERS is not heeded")
      ->group(group);
  app.parse_complete_callback([peer, &options] { leave_peers_out(*peer, options); });
}

discovery::Introduction introduction(std::string_view role) {
  return {.role = std::string(role),
          .host = host_name(),
          .process = static_cast<std::uint32_t>(::getpid()),
          .build = build(),
          .isolation = {}};
}

std::unique_ptr<Participant> join_bridges(const JoinOptions& own, const std::string& isolation) {
  if (isolation.empty()) return nullptr;
  JoinOptions options = own;
  options.isolation = isolation;
  options.loopback_only = false;
  return join(options);
}

}  // namespace lamprey::messaging::program
