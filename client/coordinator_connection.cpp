#include "client/coordinator_connection.hpp"

#include "client/failure.hpp"
#include "client/option_checks.hpp"
#include "client/output/formatting.hpp"
#include "messaging/program/join_options.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace lamprey::client {

namespace {

std::unique_ptr<messaging::Participant> join(const Environment& environment, const messaging::JoinOptions& options) {
  try {
    return environment.join(options);
  } catch (const std::runtime_error& error) {
    throw Failure(exit_unreachable, "cannot_join", error.what());
  }
}

std::string where_looked(const messaging::JoinOptions& join, const std::string& vendor) {
  std::string text = vendor + ", domain " + std::to_string(join.domain) + ", isolation " + join.isolation;
  if (join.loopback_only) return text + ", this machine only";
  if (!join.interfaces.empty()) text += ", over " + output::joined(join.interfaces, ", ");
  if (!join.discovery_servers.empty()) {
    return text + ", by discovery server " + output::joined(join.discovery_servers, ", ");
  }
  if (!join.peers.empty()) return text + ", peers " + output::joined(join.peers, ", ");
  return text + ", by multicast, no peers named";
}

/// What else there is, and how to get to it: most often it is the isolation that is wrong.
std::vector<std::string> other_coordinators(const std::vector<messaging::discovery::Participant>& others,
                                            const messaging::discovery::Introduction& own) {
  std::vector<std::string> found;
  for (const auto& other : others) {
    if (!other.introduction || other.introduction->role != "coordinator") continue;
    const auto& who = *other.introduction;
    std::string text = "a coordinator on " + who.host + " (process " + std::to_string(who.process) + ")";
    if (who.wire != own.wire) {
      text += " of another version (" + who.build + "), which this tool never meets";
    } else if (who.isolation != own.isolation) {
      text += " in isolation '" + who.isolation + "': --isolation " + who.isolation;
    } else {
      text += " that does not answer: lamprey doctor looks for the reason";
    }
    if (std::ranges::find(found, text) == found.end()) found.push_back(output::without_controls(text));
  }
  return found;
}

ExitCode exit_code_of(const std::string& error_code) {
  if (error_code == "storage") return exit_storage;
  if (error_code == "malformed" || error_code == "internal") return exit_failure;
  return exit_usage;  // unknown_sweep, invalid_specification, name_taken, sweep_changed, not_possible …
}

}  // namespace

void add_timeout_option(CLI::App& app, double& seconds) {
  app.add_option("--timeout", seconds, "How long to wait for a coordinator to answer")
      ->type_name("SECONDS")
      ->check(number(0.1, 86'400))
      ->default_str(output::shortest(seconds));
}

void add_connection_options(CLI::App& app, ConnectionOptions& options) {
  add_timeout_option(app, options.timeout_seconds);
  messaging::program::add_join_options(app, options.join);
}

CoordinatorConnection::CoordinatorConnection(const Environment& environment, ConnectionOptions options)
    : environment_(environment),
      options_(std::move(options)),
      signal_(std::make_shared<messaging::Signal>()),
      participant_(join(environment, options_.join)),
      client_(*participant_, signal_) {}

Clock::duration CoordinatorConnection::timeout() const {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.timeout_seconds));
}

idl::Reply CoordinatorConnection::ask(const idl::Request& request) {
  auto reply = client_.ask(request, timeout(), environment_.interrupted);
  if (!reply) throw interrupted() ? interrupted_failure() : unreachable();
  return std::move(*reply);
}

idl::Reply CoordinatorConnection::ask_for_success(const idl::Request& request) {
  auto reply = ask(request);
  require_success(reply);
  return reply;
}

Failure CoordinatorConnection::unreachable() {
  std::string message = "no coordinator answered within " + output::duration(options_.timeout_seconds) + " (" +
                        where_looked(options_.join, participant_->vendor()) + ")";
  if (!client_.write_error().empty()) message += "; the last request could not be sent: " + client_.write_error();
  if (const auto others = other_coordinators(participant_->others(), messaging::introduction_of(options_.join));
      !others.empty()) {
    return {exit_unreachable, "unreachable", message + ". In this domain there is " + output::joined(others, "; ")};
  }
  message += ". Is lamprey-coordinator running, with the same domain and isolation? ";
  message += options_.join.discovery_servers.empty()
                 ? "On another machine, or without multicast, name its host: --peer HOST"
                 : "Is the discovery server, and does the coordinator name it, too?";
  if (options_.file_would_do) message += ". A database file is read without it: --database FILE";
  return {exit_unreachable, "unreachable", std::move(message)};
}

void require_success(const idl::Reply& reply) {
  if (reply.kind_case() == idl::Reply::KIND_NOT_SET) {
    throw Failure(exit_failure, "malformed",
                  "the coordinator's reply holds nothing that this program knows; is it of another version?");
  }
  if (!reply.has_error()) return;
  const auto& error = reply.error();
  std::vector<std::string> messages;
  for (int i = 0; i < error.messages_size(); ++i) {
    const bool has_field = i < error.fields_size() && !error.fields(i).empty();
    messages.push_back((has_field ? error.fields(i) + ": " : "") + error.messages(i));
  }
  if (messages.empty()) messages.emplace_back("the coordinator refuses, and does not say why");
  throw Failure(exit_code_of(error.code()), error.code().empty() ? "refused" : error.code(), std::move(messages));
}

Failure interrupted_failure(std::string message) {
  return {exit_interrupted, "interrupted", std::move(message)};
}

}  // namespace lamprey::client
