#pragma once

#include "client/command.hpp"
#include "client/coordinator_client.hpp"
#include "client/failure.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace lamprey::client {

/// How to find the coordinator, and how long to look for it.
struct ConnectionOptions {
  messaging::JoinOptions join;
  double timeout_seconds = 5;
  bool file_would_do = false;  ///< --database reads the same from a file
};

/// Declares --timeout and the options that every program of ours joins by.
void add_connection_options(CLI::App& app, ConnectionOptions& options);

/// Declares --timeout alone.
void add_timeout_option(CLI::App& app, double& seconds);

/// A participant with a client on it. One thread.
class CoordinatorConnection {
 public:
  /// Joins. Throws Failure (unreachable) with the vendor's reason.
  CoordinatorConnection(const Environment& environment, ConnectionOptions options);

  /// The coordinator's reply, which may be an error. Throws Failure: unreachable, with all that was tried; interrupted.
  idl::Reply ask(const idl::Request& request);

  /// The same, but throws the Failure that an error reply stands for.
  idl::Reply ask_for_success(const idl::Request& request);

  CoordinatorClient& client() { return client_; }
  messaging::Participant& participant() { return *participant_; }
  const std::shared_ptr<messaging::Signal>& signal() const { return signal_; }
  bool interrupted() const { return environment_.interrupted(); }
  Clock::duration timeout() const;

  /// No coordinator has answered in time: says where it was looked for.
  [[nodiscard]] Failure unreachable();

 private:
  const Environment& environment_;
  ConnectionOptions options_;
  std::shared_ptr<messaging::Signal> signal_;
  std::unique_ptr<messaging::Participant> participant_;
  CoordinatorClient client_;
};

/// Throws the Failure that an error reply stands for; returns if the reply is no error. A reply that has nothing this
/// program knows is an error too.
void require_success(const idl::Reply& reply);

/// The user wants the tool to end.
Failure interrupted_failure(std::string message = "interrupted");

}  // namespace lamprey::client
