#include "client/diagnosis/domain.hpp"

#include "client/network/programs.hpp"
#include "client/output/formatting.hpp"
#include "messaging/discovery/mismatches.hpp"
#include "messaging/discovery/server_address.hpp"
#include "messaging/qos.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace lamprey::client::diagnosis {

namespace {

using Level = Check::Level;
namespace discovery = messaging::discovery;
using network::Program;

std::vector<Program> programs_of_ours(const discovery::DomainView& view) {
  auto programs = network::programs_of(view);
  std::erase_if(programs, [](const Program& program) { return !program.ours(); });
  return programs;
}

std::string listed(const std::vector<std::string>& items) {
  return output::joined(items, ", ");
}

Check check_coordinators(const std::vector<std::string>& coordinators, const messaging::JoinOptions& join) {
  const std::string isolation = "isolation " + join.isolation;
  if (coordinators.empty()) {
    return {Level::trouble, "coordinator", "none in domain " + std::to_string(join.domain) + ", " + isolation,
            std::string("Is lamprey-coordinator running, with the same domain and isolation? ") +
                (join.discovery_servers.empty() ? "Without multicast name its host: --peer HOST."
                                                : "It must name the discovery server, too.")};
  }
  if (coordinators.size() == 1) return {Level::good, "coordinator", coordinators.front(), {}};
  return {Level::trouble, "coordinator",
          "there are " + std::to_string(coordinators.size()) + " in " + isolation + ": " + listed(coordinators),
          "A client's request reaches all of them: give each an --isolation of its own."};
}

}  // namespace

std::vector<Check> check_company(const discovery::DomainView& view, const messaging::JoinOptions& join) {
  std::vector<std::string> coordinators;
  std::map<std::string, std::size_t> elsewhere;
  std::size_t here = 0;
  for (const auto& program : programs_of_ours(view)) {
    if (program.introduction.role == messaging::discovery::server_role) continue;  // it is there for any isolation
    if (program.introduction.isolation != join.isolation) {
      ++elsewhere[program.introduction.isolation];
      continue;
    }
    ++here;
    if (program.introduction.role == "coordinator") coordinators.push_back(network::to_text(program));
  }
  std::vector<Check> checks = {check_coordinators(coordinators, join)};
  checks.push_back({Level::good,
                    "programs",
                    output::counted(here, "program of Lamprey's is", "programs of Lamprey's are") + " in isolation " +
                        join.isolation,
                    {}});
  for (const auto& [isolation, count] : elsewhere) {
    const bool may_be_meant = coordinators.empty();
    checks.push_back({may_be_meant ? Level::notable : Level::good, "isolation",
                      output::counted(count, "program is", "programs are") + " in isolation " + isolation +
                          ", which never meet those in " + join.isolation,
                      may_be_meant ? "If that is where you want to be: --isolation " + isolation + "." : ""});
  }
  return checks;
}

std::vector<Check> check_servers(const discovery::DomainView& view, const messaging::JoinOptions& join) {
  std::vector<Check> checks;
  if (join.loopback_only) return checks;
  for (const auto& server : discovery::server_addresses(join.discovery_servers, join.domain)) {
    const std::string name = server.host + ":" + std::to_string(server.port);
    const bool there = std::ranges::any_of(view.participants, [&](const discovery::Participant& participant) {
      return discovery::server_identity(participant.guid) == server.identity();
    });
    if (there) {
      checks.push_back({Level::good, "discovery server", name + " is there", {}});
    } else {
      checks.push_back({Level::trouble, "discovery server", name + " doesn't answer",
                        "Is lamprey-discovery-server running there, with the same domain or port, and does a firewall "
                        "let that UDP port through? Those that have met go on without it, others don't meet."});
    }
  }
  return checks;
}

std::vector<Check> check_versions(const discovery::DomainView& view, const std::string& build) {
  std::map<std::string, std::vector<std::string>> others;
  std::vector<std::string> other_wire;
  for (const auto& program : programs_of_ours(view)) {
    if (program.introduction.wire != messaging::wire_version) {
      other_wire.push_back(network::to_text(program) + " (" + std::to_string(program.introduction.wire) + ")");
    } else if (program.introduction.build != build) {
      others[program.introduction.build].push_back(network::to_text(program));
    }
  }
  std::vector<Check> checks;
  if (!other_wire.empty()) {
    checks.push_back({Level::trouble, "version",
                      "another version on the wire than this program's " + std::to_string(messaging::wire_version) +
                          ": " + listed(other_wire),
                      "They never meet: install the same version of Lamprey everywhere."});
  }
  for (const auto& [version, programs] : others) {
    checks.push_back(
        {Level::notable, "version", "not " + build + " but " + version + ": " + listed(programs),
         "They work together, as far as their science version is the same; outcomes say which build made them."});
  }
  if (checks.empty()) checks.push_back({Level::good, "version", "the same everywhere: " + build, {}});
  return checks;
}

std::vector<Check> check_matching(const discovery::DomainView& view) {
  const auto programs = network::programs_of(view);
  std::vector<Check> checks;
  for (const auto& mismatch : discovery::mismatches(view)) {
    checks.push_back(
        {Level::trouble, "matching",
         mismatch.writer.topic + ": " + network::owner_of(mismatch.writer, programs) + " writes, " +
             network::owner_of(mismatch.reader, programs) + " reads, but " + mismatch.reason,
         "They never exchange anything on this topic: change the quality of service of the one that isn't Lamprey's."});
  }
  if (checks.empty())
    checks.push_back({Level::good, "matching", "no writer and reader of one topic fail to match", {}});
  return checks;
}

Check check_clock(double ahead_by, double uncertainty) {
  constexpr double tolerable = 1;  // seconds
  const std::string direction = ahead_by < 0 ? "behind" : "ahead of";
  const std::string finding = "the coordinator's is " + output::duration(std::abs(ahead_by)) + " " + direction +
                              " this host's (± " + output::rounded(1000 * uncertainty) + " ms)";
  if (std::abs(ahead_by) <= tolerable + uncertainty) return {Level::good, "clock", finding, {}};
  return {Level::notable, "clock", finding,
          "Outcomes don't depend on it, times in logs and events do: let NTP set both clocks."};
}

}  // namespace lamprey::client::diagnosis
