#pragma once

#include "client/command.hpp"
#include "client/network/programs.hpp"
#include "messaging/discovery/domain_view.hpp"

namespace lamprey::client::network {

/// What is known of a domain after looking for a while.
struct Sight {
  messaging::discovery::DomainView view;
  FirstTraffic first;  ///< of each participant in view.traffic
};

/// For so many seconds: nobody tells when everybody has been found. Throws Failure (unreachable, with the vendor's
/// reason; interrupted).
Sight look(const messaging::JoinOptions& join, double seconds, const Environment& environment);

}  // namespace lamprey::client::network
