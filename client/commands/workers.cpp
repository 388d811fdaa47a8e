#include "client/views/workers.hpp"

#include "client/commands/commands.hpp"
#include "client/coordinator_connection.hpp"
#include "client/views/sweeps.hpp"

#include <memory>

namespace lamprey::client::commands {

namespace {

ExitCode workers(const ConnectionOptions& options, const Context& context) {
  CoordinatorConnection connection(context.environment, options);
  idl::Request request;
  request.mutable_status();
  const auto reply = connection.ask_for_success(request);
  views::print_alarms(context.console, reply.status());
  if (context.format == Format::json) {
    Json json = document("workers");
    json["workers"] = views::workers_json(reply.status());
    print(context.console, json);
  } else {
    views::print_workers_in_detail(context.console, reply.status());
  }
  return exit_ok;
}

}  // namespace

Action declare_workers(CLI::App& app) {
  auto options = std::make_shared<ConnectionOptions>();
  app.description(
      "Shows the workers that the coordinator knows: where they run, what they hold and compute, and when they were "
      "last heard.");
  add_connection_options(app, *options);
  return [options](const Context& context) { return workers(*options, context); };
}

}  // namespace lamprey::client::commands
