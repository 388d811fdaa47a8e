#pragma once

#include "experiment/problem.hpp"
#include "messaging/port.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace lamprey::messaging::program {

/// A configuration file is bad: what app.parse() throws of it.
class BadConfiguration : public CLI::ValidationError {
 public:
  explicit BadConfiguration(experiment::InvalidInput input)
      : CLI::ValidationError(std::string(input.what())), input_(std::move(input)) {}
  const experiment::InvalidInput& input() const { return input_; }

 private:
  experiment::InvalidInput input_;
};

/// Adds --dds, --domain, --isolation, --peer, --interface, --discovery-server (these three repeatable),
/// --loopback-only and --config to the app; parsing fills `options`. Both must outlive the parsing. What the command
/// line does not say comes from the environment (LAMPREY_DDS …; join_fields.hpp), then from the configuration file
/// (--config, LAMPREY_CONFIG, or where one usually is: configuration_file.hpp), then from `options` as it is. Options
/// may be removed from the app again: then the command line and the environment don't say them.
/// A bad value of any origin, a network interface that isn't there, and what excludes each other make app.parse()
/// throw a CLI::ParseError (of a file: BadConfiguration) that says what is allowed. A site's peers, interfaces and
/// discovery servers don't keep anybody from --loopback-only, which is said in a stronger place then; said in a place
/// as strong or stronger they contradict it, also that of a file, which --loopback-only=false takes back. Of peers and
/// discovery servers the stronger ones count.
void add_join_options(CLI::App& app, JoinOptions& options);

/// What this process tells everybody in its domain, for JoinOptions: who and where it is, in that role.
discovery::Introduction introduction(std::string_view role);

/// Among the bridges of robots, where they are in another isolation than `own`, maybe on another machine; nothing if
/// `isolation` is empty. Throws JoinError.
std::unique_ptr<Participant> join_bridges(const JoinOptions& own, const std::string& isolation);

/// Logs a warning, to be called once, where the program listens to more than this machine: nobody is asked who they
/// are. `bridges_too`: it has joined with join_bridges, which listens so whatever the options say.
void warn_of_open_door(const JoinOptions& options, bool bridges_too = false);

}  // namespace lamprey::messaging::program
