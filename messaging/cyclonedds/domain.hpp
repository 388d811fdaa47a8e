#pragma once

#include "messaging/cyclonedds/configuration.hpp"
#include "messaging/cyclonedds/entity.hpp"
#include "messaging/port.hpp"

#include <dds/dds.h>

namespace lamprey::messaging::cyclonedds {

/// A domain of its own within the process for each participant: two in one process would otherwise share one domain,
/// which has one configuration and hands samples over without the network. The first takes the number that it has on
/// the network, so that the user's configuration may address it; others only look like it from outside. Throws
/// std::runtime_error with Cyclone's reason.
Entity make_domain(const JoinOptions& options, KeyHashes key_hashes = KeyHashes::sent);

/// The domain's number within the process.
dds_domainid_t number_of(const Entity& domain);

}  // namespace lamprey::messaging::cyclonedds
