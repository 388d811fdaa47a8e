#pragma once

#include "messaging/port.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <string_view>

namespace lamprey::messaging::program {

/// Adds --dds, --domain, --isolation, --peer (repeatable) and --loopback-only to the app; parsing fills `options`,
/// which must outlive the app. What the command line does not say comes from LAMPREY_DDS, LAMPREY_DOMAIN (else
/// ROS_DOMAIN_ID), LAMPREY_ISOLATION and LAMPREY_PEERS ("HOST,HOST"), then from `options` as it is. A bad value of
/// either origin makes app.parse() throw a CLI::ParseError that says what is allowed.
void add_join_options(CLI::App& app, JoinOptions& options);

/// What this process tells everybody in its domain, for JoinOptions: who and where it is, in that role.
discovery::Introduction introduction(std::string_view role);

/// Among the bridges of robots, where they are in another isolation than `own`, maybe on another machine; nothing if
/// `isolation` is empty. Throws JoinError.
std::unique_ptr<Participant> join_bridges(const JoinOptions& own, const std::string& isolation);

}  // namespace lamprey::messaging::program
