#include "messaging/program/join_options.hpp"

#include "experiment/problem.hpp"
#include "messaging/discovery/server_address.hpp"
#include "messaging/network_interfaces.hpp"
#include "messaging/process_identity.hpp"
#include "messaging/program/build_info.hpp"
#include "messaging/program/configuration_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <spdlog/spdlog.h>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace lamprey::messaging::program {
namespace {

using Values = std::vector<std::string>;

std::string joined(const Values& values) {
  std::string text;
  for (const auto& value : values) text += (text.empty() ? "" : ", ") + value;
  return text;
}

/// Where a field's values are from; the stronger the later.
enum class Origin : unsigned char { program, file, environment, command_line };

void add_option(CLI::App& app, JoinOptions& options, const JoinField& field) {
  const auto set = [&options, set = field.set](const Values& values) { set(options, values); };
  const auto check = [fault = field.fault, origins = " (option or " + field.variable + ")"](const std::string& value) {
    const auto text = fault(value);
    return text.empty() ? text : text + origins;
  };
  CLI::Option* option = nullptr;
  switch (field.kind) {
    case JoinField::Kind::flag:
      option = app.add_flag_function(
          field.option, [set](std::int64_t count) { set({count > 0 ? "true" : "false"}); }, field.meaning);
      break;
    case JoinField::Kind::list:
      option = app.add_option_function<Values>(field.option, set, field.meaning)
                   ->delimiter(',')
                   ->allow_extra_args(false)
                   ->check(check);
      break;
    case JoinField::Kind::single:
      option = app.add_option_function<std::string>(
                      field.option, [set](const std::string& value) { set({value}); }, field.meaning)
                   ->check(check)
                   ->default_str(field.get(options).front());
      break;
  }
  if (!field.variable.empty()) option->envname(field.variable);
  if (!field.value.empty()) option->type_name(field.value);
  option->group("DDS");
}

/// What the command line and the environment have left open, and what all of it together comes to.
class Completion {
 public:
  Completion(const CLI::App& app, JoinOptions& options) : app_(app), options_(options), fields_(join_fields()) {
    if (options_.configuration_file.empty()) options_.configuration_file = usual_configuration_file();
    if (options_.configuration_file.empty()) return;
    try {
      file_ = read_configuration(options_.configuration_file, fields_);
    } catch (const experiment::InvalidInput& error) {
      throw BadConfiguration(error);
    }
  }

  void complete() {
    for (const auto& field : fields_) {
      if (origin_of(field) == Origin::file) field.set(options_, file_.find(field.name)->values);
    }
    exclude();
    if (options_.loopback_only) return;
    check_interfaces();
    check_servers();
  }

 private:
  const JoinField& field(std::string_view name) const { return *std::ranges::find(fields_, name, &JoinField::name); }

  const CLI::Option* option_of(const JoinField& field) const { return app_.get_option_no_throw(field.option); }

  Origin origin_of(const JoinField& field) const {
    const auto* const option = option_of(field);
    if (option != nullptr && option->count() > 0) {
      const char* const value = field.variable.empty() ? nullptr : std::getenv(field.variable.c_str());
      // Who repeats on the command line what the environment says has said it there.
      const bool same = value != nullptr && option->results() == CLI::detail::split(value, ',');
      return same ? Origin::environment : Origin::command_line;
    }
    return file_.find(field.name) == nullptr ? Origin::program : Origin::file;
  }

  /// As a user finds it again.
  std::string place_of(const JoinField& field) const {
    switch (origin_of(field)) {
      case Origin::environment:
        return field.variable;
      case Origin::file:
        return file_.file + ":" + std::to_string(file_.find(field.name)->line) + ": " + field.name;
      default:
        return field.option;
    }
  }

  void exclude() {
    const auto& loopback = field("loopback_only");
    for (const auto* const name : {"peers", "interfaces", "discovery_servers"}) {
      const auto& other = field(name);
      if (!options_.loopback_only || other.get(options_).empty()) continue;
      if (origin_of(other) >= origin_of(loopback)) throw CLI::ExcludesError(place_of(loopback), place_of(other));
    }
    const auto& servers = field("discovery_servers");
    const auto& peers = field("peers");
    if (servers.get(options_).empty() || peers.get(options_).empty()) return;
    if (origin_of(servers) == origin_of(peers)) throw CLI::ExcludesError(place_of(servers), place_of(peers));
    (origin_of(servers) > origin_of(peers) ? peers : servers).set(options_, {});
  }

  void check_interfaces() const {
    const auto& interfaces = field("interfaces");
    if (options_.interfaces.empty() || option_of(interfaces) == nullptr) return;
    const auto existing = network_interfaces();
    std::vector<std::string_view> known;
    for (const auto& interface : existing) known.insert(known.end(), {interface.name, interface.address});
    for (const auto& chosen : options_.interfaces) {
      const auto fault = interface_fault(chosen, existing);
      if (!fault.empty()) refuse(interfaces, fault + experiment::nearest_hint(chosen, known));
    }
    try {
      addresses_of(options_.interfaces, existing);
    } catch (const std::runtime_error& error) {
      refuse(interfaces, error.what());
    }
  }

  void check_servers() const {
    const auto& servers = field("discovery_servers");
    if (options_.discovery_servers.empty() || option_of(servers) == nullptr) return;
    if (options_.vendor == "cyclonedds") {
      refuse(servers, "Cyclone DDS has no discovery server: take Fast DDS (--dds fastdds), or name a peer instead");
    }
    try {
      discovery::server_addresses(options_.discovery_servers, options_.domain);
    } catch (const std::runtime_error& error) {
      refuse(servers, error.what());
    }
  }

  [[noreturn]] void refuse(const JoinField& field, const std::string& reason) const {
    throw CLI::ValidationError(place_of(field) + ": " + reason);
  }

  const CLI::App& app_;
  JoinOptions& options_;
  std::vector<JoinField> fields_;
  Configuration file_;
};

}  // namespace

void add_join_options(CLI::App& app, JoinOptions& options) {
  for (const auto& field : join_fields()) add_option(app, options, field);
  app.add_option("--config", options.configuration_file,
                 "a file with these options (default: ~/.config/lamprey/lamprey.yaml, else /etc/lamprey/lamprey.yaml)")
      ->envname("LAMPREY_CONFIG")
      ->type_name("FILE")
      ->group("DDS");
  app.parse_complete_callback([&app, &options] { Completion(app, options).complete(); });
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

void warn_of_open_door(const JoinOptions& options, bool bridges_too) {
  if (options.loopback_only && !bridges_too) return;
  const std::string where = options.interfaces.empty() ? "the network" : joined(options.interfaces);
  spdlog::warn(
      "there is no security: whoever reaches this host over {} may join domain {}, see everything and change "
      "anything{}",
      where, options.domain,
      options.loopback_only ? "; only for its robot does this program listen there"
                            : "; --loopback-only keeps programs on this machine");
}

}  // namespace lamprey::messaging::program
