#pragma once

#include "client/coordinator_connection.hpp"

#include <string>
#include <string_view>

namespace lamprey::client {

/// What every command that steers a sweep takes.
struct ControlOptions {
  std::string sweep;
  ConnectionOptions connection;
};

/// Declares SWEEP and the options of the connection.
void add_control_options(CLI::App& app, ControlOptions& options);

/// A request that tells the sweep to do so.
idl::Request control_request(const std::string& sweep, idl::ControlRequest::Action action);

/// What the coordinator answers; throws the Failure that an error stands for.
idl::ControlReply steer(const ControlOptions& options, const Context& context, const idl::Request& request);

/// Writes the answer: the text for people, or the document lamprey/<command>/1 with sweep, state and jobs.
void print_control(const Context& context, std::string_view command, const std::string& sweep,
                   const idl::ControlReply& reply, const std::string& text);

}  // namespace lamprey::client
