#include "client/commands/commands.hpp"
#include "client/coordinator_connection.hpp"
#include "client/diagnosis/domain.hpp"
#include "client/diagnosis/host.hpp"
#include "client/json.hpp"
#include "client/network/look.hpp"
#include "client/option_checks.hpp"
#include "client/output/formatting.hpp"
#include "messaging/program/build_info.hpp"
#include "messaging/program/join_options.hpp"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <sys/statvfs.h>
#include <vector>

namespace lamprey::client::commands {

namespace {

using diagnosis::Check;

struct Options {
  ConnectionOptions connection;
  double seconds = 3;
};

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

Check shared_memory(const messaging::JoinOptions& join) {
  const std::filesystem::path folder = "/dev/shm";
  struct statvfs space {};
  const bool known = ::statvfs(folder.c_str(), &space) == 0;
  std::size_t segments = 0;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    segments += entry->path().filename().string().starts_with("fastrtps_") ? 1U : 0U;
  }
  const bool profile = join.vendor == "fastdds" && !variable("FASTRTPS_DEFAULT_PROFILES_FILE").empty();
  return diagnosis::check_shared_memory(known ? std::uint64_t{space.f_bavail} * space.f_frsize : 0, segments, profile);
}

std::vector<Check> check_host(const messaging::JoinOptions& join) {
  auto checks = diagnosis::check_environment(variable, join);
  const auto interfaces = messaging::network_interfaces();
  checks.push_back(diagnosis::check_interfaces(interfaces, join));
  std::ranges::move(diagnosis::check_multicast(interfaces, join, diagnosis::multicast_fault),
                    std::back_inserter(checks));
  auto bound = diagnosis::bound_ports(text_of("/proc/net/udp"));
  bound.merge(diagnosis::bound_ports(text_of("/proc/net/udp6")));
  checks.push_back(diagnosis::check_ports(bound, join.domain));
  checks.push_back(
      diagnosis::check_receive_buffers(std::strtoull(text_of("/proc/sys/net/core/rmem_max").c_str(), nullptr, 10)));
  checks.push_back(shared_memory(join));
  return checks;
}

/// Asks the coordinator what time it is.
std::vector<Check> check_answer(const Options& options, const Context& context) {
  using std::chrono::duration;
  using std::chrono::system_clock;
  idl::Request request;
  request.mutable_status();
  try {
    CoordinatorConnection connection(context.environment, options.connection);
    // The first answer has taken as long as finding each other.
    connection.ask_for_success(request);
    const auto asked = system_clock::now();
    const auto reply = connection.ask_for_success(request);
    const auto answered = system_clock::now();
    const double uncertainty = duration<double>(answered - asked).count() / 2;
    const auto middle = duration<double>(asked.time_since_epoch()).count() + uncertainty;
    return {
        {Check::Level::good,
         "answer",
         "the coordinator answers within " + output::rounded(2000 * uncertainty) + " ms",
         {}},
        diagnosis::check_clock(static_cast<double>(reply.status().unix_milliseconds()) / 1000 - middle, uncertainty)};
  } catch (const Failure& failure) {
    if (failure.exit_code() != exit_unreachable) throw;
    return {
        {Check::Level::trouble, "answer", "the coordinator is there, but doesn't answer",
         "Discovery goes both ways, data does not: is there a firewall, an address that can't be reached from here, "
         "or is it --loopback-only?"}};
  }
}

std::vector<Check> check_domain(const Options& options, const Context& context) {
  const auto& join = options.connection.join;
  const auto view = network::look(join, options.seconds, context.environment).view;
  auto checks = diagnosis::check_company(view, join);
  const bool alone = checks.front().level == Check::Level::trouble;
  std::ranges::move(diagnosis::check_servers(view, join), std::back_inserter(checks));
  std::ranges::move(diagnosis::check_versions(view, messaging::program::build()), std::back_inserter(checks));
  std::ranges::move(diagnosis::check_matching(view), std::back_inserter(checks));
  if (!alone) std::ranges::move(check_answer(options, context), std::back_inserter(checks));
  return checks;
}

std::string_view word(Check::Level level) {
  constexpr std::array<std::string_view, 3> words{"ok", "note", "trouble"};
  return words[static_cast<std::size_t>(level)];
}

void print_text(const std::vector<Check>& checks, const Context& context) {
  const auto& console = context.console;
  for (const auto& check : checks) {
    const auto mark = check.level == Check::Level::trouble   ? console.alert("trouble")
                      : check.level == Check::Level::notable ? console.bold("note   ")
                                                             : console.good("ok     ");
    console.out << mark << "  " << check.subject << ": " << output::without_controls(check.finding) << '\n';
    for (const auto& line : output::wrap(output::without_controls(check.advice), console.columns - 11)) {
      console.out << "           " << line << '\n';
    }
  }
}

void print_json(const std::vector<Check>& checks, const Context& context) {
  Json json = document("doctor");
  json["checks"] = Json::array();
  for (const auto& check : checks) {
    json["checks"].push_back({{"subject", check.subject},
                              {"level", word(check.level)},
                              {"finding", check.finding},
                              {"advice", check.advice}});
  }
  print(context.console, json);
}

ExitCode doctor(const Options& options, const Context& context) {
  auto checks = check_host(options.connection.join);
  std::ranges::move(check_domain(options, context), std::back_inserter(checks));
  context.format == Format::json ? print_json(checks, context) : print_text(checks, context);
  const bool trouble =
      std::ranges::any_of(checks, [](const Check& check) { return check.level == Check::Level::trouble; });
  return trouble ? exit_mismatch : exit_ok;
}

}  // namespace

Action declare_doctor(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Looks for what keeps programs from meeting: interfaces, multicast, peers, discovery servers, ports, buffers, "
      "shared memory, domains and "
      "isolations, versions, quality of service, clocks; and says what to do. Exit code 5 if there is trouble.");
  app.add_option("--seconds", options->seconds, "Look for others so long")
      ->check(number(0.1, 600))
      ->type_name("S")
      ->capture_default_str();
  add_connection_options(app, options->connection);
  app.footer("Example\n  lamprey doctor\n  lamprey doctor --peer coordinator.lab");
  return [options](const Context& context) { return doctor(*options, context); };
}

}  // namespace lamprey::client::commands
