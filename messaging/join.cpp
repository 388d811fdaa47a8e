#include "messaging/discovery/server.hpp"
#include "messaging/discovery/server_address.hpp"
#include "messaging/discovery/watch.hpp"
#include "messaging/names.hpp"
#include "messaging/network_interfaces.hpp"
#include "messaging/port.hpp"
#include "messaging/vendor_library.hpp"

#include <algorithm>
#include <cstdint>
#include <dlfcn.h>
#include <filesystem>
#include <memory>
#include <netdb.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace lamprey::messaging {
namespace {

/// Where vendor libraries may be: next to the program, or in the lib folder beside its own.
std::vector<std::filesystem::path> library_folders() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw JoinError("cannot find the program's own folder: " + error.message());
  const auto folder = program.parent_path();
  return {folder, folder.parent_path() / "lib"};
}

std::vector<std::string> vendors_in(const std::vector<std::filesystem::path>& folders) {
  const std::string_view prefix = vendor_library_prefix;
  const std::string_view suffix = ".so";
  std::vector<std::string> vendors;
  for (const auto& folder : folders) {
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
      const std::string name = entry->path().filename().string();
      if (name.size() <= prefix.size() + suffix.size() || !name.starts_with(prefix) || !name.ends_with(suffix))
        continue;
      vendors.push_back(name.substr(prefix.size(), name.size() - prefix.size() - suffix.size()));
    }
  }
  std::sort(vendors.begin(), vendors.end());
  vendors.erase(std::unique(vendors.begin(), vendors.end()), vendors.end());
  return vendors;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

[[noreturn]] void fail(const JoinOptions& options, const std::string& reason) {
  const auto folders = library_folders();
  const auto vendors = vendors_in(folders);
  throw JoinError(
      "cannot join DDS domain " + std::to_string(options.domain) + " with '" + options.vendor + "': " + reason +
      " (vendors that exist: " +
      (vendors.empty() ? "none in " + folders.front().string() + " or " + folders.back().string() : joined(vendors)) +
      ")");
}

/// Only names from the folder listing are loaded, so a name cannot lead out of the folders.
std::filesystem::path find_library(const JoinOptions& options) {
  const auto folders = library_folders();
  const auto vendors = vendors_in(folders);
  if (std::find(vendors.begin(), vendors.end(), options.vendor) == vendors.end()) fail(options, "no such vendor");
  for (const auto& folder : folders) {
    const auto path = folder / (vendor_library_prefix + options.vendor + ".so");
    if (std::filesystem::exists(path)) return path;
  }
  fail(options, "its library has vanished");
}

/// Throws std::runtime_error where a host can't be looked for. Checked here because Cyclone only warns.
void require_usable(const std::string& what, const std::string& host) {
  const std::string named = what + " '" + host + "' ";
  if (!is_valid_peer(host)) throw std::runtime_error(named + "is not a host name or address");
  addrinfo* addresses = nullptr;
  const int error = getaddrinfo(host.c_str(), nullptr, nullptr, &addresses);
  if (error != 0) throw std::runtime_error(named + "cannot be resolved: " + gai_strerror(error));
  freeaddrinfo(addresses);
}

/// As the vendors get them: without what has no meaning, with hosts that resolve, and with interfaces as addresses.
/// Throws std::runtime_error.
JoinOptions settled(JoinOptions options) {
  if (options.loopback_only) {
    options.peers.clear();
    options.interfaces.clear();
    options.discovery_servers.clear();
  }
  for (const auto& peer : options.peers) require_usable("peer", peer);
  for (const auto& server : discovery::server_addresses(options.discovery_servers, options.domain)) {
    require_usable("discovery server", server.host);
  }
  if (!options.interfaces.empty()) options.interfaces = addresses_of(options.interfaces, network_interfaces());
  return options;
}

/// What the function of that name in the vendor's library makes.
template <class Member, class... More>
std::unique_ptr<Member> make(const char* function_name, const JoinOptions& options, More... more) {
  JoinOptions settled_options;
  try {
    settled_options = settled(options);
  } catch (const std::runtime_error& error) {
    fail(options, error.what());
  }
  const auto path = find_library(options);
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr) fail(options, dlerror());
  // POSIX says that dlsym's object pointer may be converted so.
  const auto function = reinterpret_cast<JoinFunction<Member, More...>>(dlsym(library, function_name));
  if (function == nullptr) fail(options, path.string() + " does not export " + function_name);
  std::string error;
  std::unique_ptr<Member> member(function(settled_options, more..., error));
  if (member == nullptr) fail(options, error);
  return member;
}

}  // namespace

std::vector<std::string> available_vendors() {
  return vendors_in(library_folders());
}

std::unique_ptr<Participant> join(const JoinOptions& options) {
  if (!is_valid_isolation(options.isolation)) {
    fail(options, "isolation '" + options.isolation + "' is not 1 to 64 letters, digits, '_', '.' or '-'");
  }
  return make<Participant>(join_function_name, options);
}

std::unique_ptr<discovery::Watch> discovery::watch(const JoinOptions& options) {
  return make<Watch>(watch_function_name, options);
}

std::unique_ptr<discovery::Server> discovery::serve(const JoinOptions& options, std::uint16_t port) {
  return make<Server>(serve_discovery_function_name, options, port);
}

std::unique_ptr<ros2::Node> ros2::join(const JoinOptions& options) {
  return make<Node>(join_ros2_function_name, options);
}

}  // namespace lamprey::messaging
