#include "messaging/program/join_fields.hpp"

#include "experiment/problem.hpp"
#include "messaging/discovery/server_address.hpp"
#include "messaging/names.hpp"
#include "messaging/tuning.hpp"
#include "messaging/vendor_library.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string>
#include <system_error>

namespace lamprey::messaging::program {
namespace {

using Values = std::vector<std::string>;

std::string vendor_fault(const std::string& vendor) {
  const auto vendors = available_vendors();
  if (std::ranges::find(vendors, vendor) != vendors.end()) return {};
  std::string text = "there is no DDS vendor '" + vendor + "'; there ";
  if (vendors.empty()) return text + "is no vendor library beside this program";
  text += vendors.size() == 1 ? "is " : "are ";
  for (std::size_t i = 0; i < vendors.size(); ++i) text += (i == 0 ? "" : ", ") + vendors[i];
  return text + experiment::nearest_hint(vendor, {vendors.begin(), vendors.end()});
}

bool read_domain(const std::string& text, std::uint32_t& domain) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), domain);
  return error == std::errc{} && end == text.data() + text.size() && domain <= highest_domain;
}

std::string domain_fault(const std::string& text) {
  std::uint32_t domain = 0;
  if (read_domain(text, domain)) return {};
  return "'" + text + "' is not a DDS domain: a whole number from 0 to " + std::to_string(highest_domain);
}

std::string isolation_fault(const std::string& name) {
  if (is_valid_isolation(name)) return {};
  return "'" + name + "' is not an isolation: 1 to 64 letters, digits, '_', '.' or '-'";
}

std::string peer_fault(const std::string& peer) {
  return is_valid_peer(peer) ? "" : "'" + peer + "' is not a host name or address";
}

/// Which there are changes with time, and only who uses one must find it: that is looked at afterwards.
std::string interface_name_fault(const std::string& name) {
  return name.empty() ? "'' is not a network interface's name or address" : "";
}

std::string server_text_fault(const std::string& text) {
  return discovery::server_fault(text);
}

std::string flag_fault(const std::string& text) {
  return text == "true" || text == "false" ? "" : "'" + text + "' is neither true nor false";
}

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

/// A field that holds a list as it is.
template <Values JoinOptions::*member>
JoinField list_field(JoinField field) {
  field.kind = JoinField::Kind::list;
  field.get = [](const JoinOptions& options) { return options.*member; };
  field.set = [](JoinOptions& options, const Values& values) { options.*member = values; };
  return field;
}

/// A field that holds a text as it is.
template <std::string JoinOptions::*member>
JoinField text_field(JoinField field) {
  field.get = [](const JoinOptions& options) { return Values{options.*member}; };
  field.set = [](JoinOptions& options, const Values& values) { options.*member = values.front(); };
  return field;
}

}  // namespace

std::vector<JoinField> join_fields() {
  return {
      text_field<&JoinOptions::vendor>({
          .name = "dds",
          .option = "--dds",
          .variable = "LAMPREY_DDS",
          .value = "VENDOR",
          .meaning = "DDS implementation: cyclonedds or fastdds; they understand each other",
          .fault = vendor_fault,
      }),
      {
          .name = "domain",
          .option = "--domain",
          .variable = is_set("LAMPREY_DOMAIN") ? "LAMPREY_DOMAIN" : "ROS_DOMAIN_ID",
          .value = "NUMBER",
          .meaning = "DDS domain, 0 to " + std::to_string(highest_domain),
          .fault = domain_fault,
          .get = [](const JoinOptions& options) { return Values{std::to_string(options.domain)}; },
          .set = [](JoinOptions& options, const Values& values) { read_domain(values.front(), options.domain); },
      },
      text_field<&JoinOptions::isolation>({
          .name = "isolation",
          .option = "--isolation",
          .variable = "LAMPREY_ISOLATION",
          .value = "NAME",
          .meaning = "only programs of the same isolation meet",
          .fault = isolation_fault,
      }),
      list_field<&JoinOptions::peers>({
          .name = "peers",
          .option = "--peer",
          .variable = "LAMPREY_PEERS",
          .value = "HOST",
          .meaning = "a host to look for without multicast, such as the coordinator's; repeatable, or 'HOST,HOST'",
          .fault = peer_fault,
      }),
      list_field<&JoinOptions::interfaces>({
          .name = "interfaces",
          .option = "--interface",
          .variable = "LAMPREY_INTERFACES",
          .value = "NAME",
          .meaning = "a network interface, by name or IPv4 address: no others are used; repeatable, or 'NAME,NAME'",
          .fault = interface_name_fault,
      }),
      list_field<&JoinOptions::discovery_servers>({
          .name = "discovery_servers",
          .option = "--discovery-server",
          .variable = "LAMPREY_DISCOVERY_SERVERS",
          .value = "HOST[:PORT]",
          .meaning = "a discovery server of Fast DDS's, by which alone programs find each other; repeatable, or "
                     "'HOST,HOST'",
          .fault = server_text_fault,
      }),
      {
          .name = "loopback_only",
          .option = "--loopback-only",
          .meaning = "meet programs on this machine only; peers, interfaces and discovery servers are not heeded",
          .kind = JoinField::Kind::flag,
          .fault = flag_fault,
          .get = [](const JoinOptions& options) { return Values{options.loopback_only ? "true" : "false"}; },
          .set = [](JoinOptions& options, const Values& values) { options.loopback_only = values.front() == "true"; },
      },
  };
}

}  // namespace lamprey::messaging::program
