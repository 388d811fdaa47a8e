#pragma once

#include "client/command.hpp"
#include "messaging/discovery/domain_view.hpp"

namespace lamprey::client::network {

/// What is known of the domain after so many seconds: nobody tells when everybody has been found. Throws Failure
/// (unreachable, with the vendor's reason; interrupted).
messaging::discovery::DomainView look(const messaging::JoinOptions& join, double seconds,
                                      const Environment& environment);

}  // namespace lamprey::client::network
