#include "client/commands/commands.hpp"
#include "client/coordinator_connection.hpp"
#include "client/json.hpp"

#include <memory>

namespace lamprey::client::commands {

namespace {

ExitCode metrics(const ConnectionOptions& options, const Context& context) {
  CoordinatorConnection connection(context.environment, options);
  idl::Request request;
  request.mutable_metrics();
  const auto reply = connection.ask_for_success(request);
  if (context.format == Format::json) {
    Json json = document("metrics");
    json["text"] = reply.metrics().text();
    print(context.console, json);
  } else {
    context.console.out << reply.metrics().text();
  }
  return exit_ok;
}

}  // namespace

Action declare_metrics(CLI::App& app) {
  auto options = std::make_shared<ConnectionOptions>();
  app.description(
      "Prints what the coordinator has counted and measured, in the text format of Prometheus: jobs, leases, results, "
      "what was refused, times of commits.");
  add_connection_options(app, *options);
  return [options](const Context& context) { return metrics(*options, context); };
}

}  // namespace lamprey::client::commands
