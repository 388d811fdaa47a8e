#pragma once

#include "messaging/discovery/domain_view.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lamprey::client::network {

/// One program of a domain, as discovery shows it: a process of ours with all of its participants, or a participant of
/// somebody else's.
struct Program {
  messaging::discovery::Introduction introduction;  ///< empty of a program that is not ours
  std::vector<messaging::discovery::Guid> participants;
  std::vector<std::string> vendors;  ///< sorted, each once
  std::string name;                  ///< of a participant that has one
  std::size_t writers = 0;
  std::size_t readers = 0;

  bool ours() const { return !introduction.role.empty(); }
};

/// Coordinators first, then by role, host and process; those that are not ours last, by GUID.
std::vector<Program> programs_of(const messaging::discovery::DomainView& view);

/// "worker alpha/4711", or "participant 01100f5a.8d1c47c4.c17eb1a2 (rviz2)" of one that is not ours.
std::string to_text(const Program& program);

/// Which program an endpoint belongs to; "an unknown program" where its participant is not known (yet).
std::string owner_of(const messaging::discovery::Endpoint& endpoint, const std::vector<Program>& programs);

}  // namespace lamprey::client::network
