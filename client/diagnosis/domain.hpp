#pragma once

#include "client/diagnosis/check.hpp"
#include "messaging/discovery/domain_view.hpp"
#include "messaging/port.hpp"

#include <optional>
#include <string>
#include <vector>

/// What discovery shows of everybody else.
namespace lamprey::client::diagnosis {

/// Whether there is one coordinator in this isolation, and who is in others.
std::vector<Check> check_company(const messaging::discovery::DomainView& view, const messaging::JoinOptions& join);

/// Whether the discovery servers that the program asks are there.
std::vector<Check> check_servers(const messaging::discovery::DomainView& view, const messaging::JoinOptions& join);

/// Whether all of our programs are of one version, `build` being this one's, and speak the same version on the wire.
std::vector<Check> check_versions(const messaging::discovery::DomainView& view, const std::string& build);

/// Writers and readers that don't meet.
std::vector<Check> check_matching(const messaging::discovery::DomainView& view);

/// `ahead_by`: seconds by which the coordinator's clock is ahead of this host's, known up to ± `uncertainty`. Nothing
/// depends on clocks but people who read logs and events of several hosts side by side.
Check check_clock(double ahead_by, double uncertainty);

}  // namespace lamprey::client::diagnosis
