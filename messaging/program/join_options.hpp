#pragma once

#include "messaging/port.hpp"

#include <CLI/CLI.hpp>

namespace lamprey::messaging::program {

/// Adds --dds, --domain, --isolation, --peer (repeatable) and --loopback-only to the app; parsing fills `options`,
/// which must outlive the app. What the command line does not say comes from LAMPREY_DDS, LAMPREY_DOMAIN (else
/// ROS_DOMAIN_ID) and LAMPREY_ISOLATION, then from `options` as it is. A bad value of either origin makes app.parse()
/// throw a CLI::ParseError that says what is allowed.
void add_join_options(CLI::App& app, JoinOptions& options);

}  // namespace lamprey::messaging::program
