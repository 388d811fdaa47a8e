#pragma once

#include "messaging/discovery/domain_view.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lamprey::client::network {

/// Samples that a program has exchanged since it joined, and how many it did in each second that was looked.
struct ProgramTraffic {
  std::uint64_t written = 0;
  std::uint64_t refused = 0;
  std::uint64_t read = 0;
  std::uint64_t malformed = 0;
  double written_per_second = 0;
  double read_per_second = 0;
  bool has_rates = false;  ///< it has told twice
};

/// One program of a domain, as discovery shows it: a process of ours with all of its participants, or a participant of
/// somebody else's.
struct Program {
  messaging::discovery::Introduction introduction;  ///< empty of a program that is not ours
  std::vector<messaging::discovery::Guid> participants;
  std::vector<std::string> vendors;  ///< sorted, each once
  std::string name;                  ///< of a participant that has one
  std::size_t writers = 0;
  std::size_t readers = 0;
  std::optional<ProgramTraffic> traffic{};  ///< of a program that tells: ours that stay

  bool ours() const { return !introduction.role.empty(); }
};

/// The first counts that each participant was seen to tell.
using FirstTraffic = std::map<messaging::discovery::Guid, messaging::Traffic>;

/// Coordinators first, then by role, host and process; those that are not ours last, by GUID.
/// `first`: to tell rates by.
std::vector<Program> programs_of(const messaging::discovery::DomainView& view, const FirstTraffic& first = {});

/// "worker alpha/4711", or "participant 01100f5a.8d1c47c4.c17eb1a2 (rviz2)" of one that is not ours.
std::string to_text(const Program& program);

/// Which program an endpoint belongs to; "an unknown program" where its participant is not known (yet).
std::string owner_of(const messaging::discovery::Endpoint& endpoint, const std::vector<Program>& programs);

}  // namespace lamprey::client::network
