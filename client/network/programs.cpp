#include "client/network/programs.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace lamprey::client::network {

namespace discovery = messaging::discovery;

namespace {

/// A process of ours may have several participants; of others nobody knows which belong together.
bool same_program(const Program& program, const discovery::Participant& participant) {
  return program.ours() && participant.introduction && program.introduction.role == participant.introduction->role &&
         program.introduction.host == participant.introduction->host &&
         program.introduction.process == participant.introduction->process;
}

void add(Program& program, const discovery::Participant& participant) {
  program.participants.push_back(participant.guid);
  const auto vendor = discovery::vendor_of(participant);
  const auto place = std::ranges::lower_bound(program.vendors, vendor);
  if (place == program.vendors.end() || *place != vendor) program.vendors.insert(place, vendor);
}

auto order_of(const Program& program) {
  const auto& who = program.introduction;
  return std::tuple(!program.ours(), who.role != "coordinator", who.role, who.host, who.process,
                    program.participants.front());
}

struct Totals {
  std::uint64_t written = 0;
  std::uint64_t refused = 0;
  std::uint64_t read = 0;
};

Totals totals_of(const messaging::Traffic& traffic) {
  Totals totals;
  for (const auto& topic : traffic.topics) {
    totals.written += topic.written;
    totals.refused += topic.refused;
    totals.read += topic.read;
  }
  return totals;
}

/// What came from the network may count down.
double per_second(std::uint64_t from, std::uint64_t to, double seconds) {
  return to < from ? 0 : static_cast<double>(to - from) / seconds;
}

void add(ProgramTraffic& to, const messaging::Traffic& first, const messaging::Traffic& last) {
  const auto begin = totals_of(first);
  const auto end = totals_of(last);
  to.written += end.written;
  to.refused += end.refused;
  to.read += end.read;
  to.malformed += last.malformed;
  const double seconds = last.seconds - first.seconds;
  if (!(seconds > 0)) return;
  to.has_rates = true;
  to.written_per_second += per_second(begin.written, end.written, seconds);
  to.read_per_second += per_second(begin.read, end.read, seconds);
}

}  // namespace

std::vector<Program> programs_of(const discovery::DomainView& view, const FirstTraffic& first) {
  std::vector<Program> programs;
  std::map<discovery::Guid, std::size_t> program_of;
  for (const auto& participant : view.participants) {
    auto program =
        std::ranges::find_if(programs, [&](const Program& known) { return same_program(known, participant); });
    if (program == programs.end()) {
      program = programs.insert(
          programs.end(), {participant.introduction.value_or(discovery::Introduction{}), {}, {}, participant.name});
    }
    add(*program, participant);
    program_of[participant.guid] = static_cast<std::size_t>(program - programs.begin());
  }
  for (const auto& endpoint : view.endpoints) {
    const auto owner = program_of.find(endpoint.participant);
    if (owner == program_of.end()) continue;
    auto& program = programs[owner->second];
    ++(endpoint.writes ? program.writers : program.readers);
  }
  for (const auto& traffic : view.traffic) {
    const auto owner = program_of.find(traffic.participant);
    if (owner == program_of.end()) continue;
    const auto earlier = first.find(traffic.participant);
    auto& program = programs[owner->second];
    if (!program.traffic) program.traffic.emplace();
    add(*program.traffic, earlier != first.end() ? earlier->second : traffic, traffic);
  }
  std::ranges::sort(programs, {}, order_of);
  return programs;
}

std::string to_text(const Program& program) {
  const auto& who = program.introduction;
  if (program.ours()) return who.role + " " + who.host + "/" + std::to_string(who.process);
  const std::string prefix = discovery::to_text(program.participants.front()).substr(0, 26);
  return "participant " + prefix + (program.name.empty() ? "" : " (" + program.name + ")");
}

std::string owner_of(const discovery::Endpoint& endpoint, const std::vector<Program>& programs) {
  for (const auto& program : programs) {
    if (std::ranges::find(program.participants, endpoint.participant) != program.participants.end()) {
      return to_text(program);
    }
  }
  return "an unknown program";
}

}  // namespace lamprey::client::network
