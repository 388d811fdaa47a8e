#include "client/commands/commands.hpp"
#include "client/coordinator_connection.hpp"
#include "client/json.hpp"

#include <memory>
#include <string>
#include <vector>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string worker;
  ConnectionOptions connection;
};

ExitCode drain(const Options& options, const Context& context) {
  CoordinatorConnection connection(context.environment, options.connection);
  idl::Request request;
  request.mutable_drain()->set_worker(options.worker);
  const auto reply = connection.ask_for_success(request);
  const auto& workers = reply.drain().workers();
  if (context.format == Format::json) {
    Json json = document("drain");
    json["workers"] = std::vector<std::string>(workers.begin(), workers.end());
    print(context.console, json);
    return exit_ok;
  }
  for (const auto& worker : workers) {
    context.console.out << "Worker " << worker << " finishes what it holds and leaves.\n";
  }
  return exit_ok;
}

}  // namespace

Action declare_drain(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Sends a worker home: it gets nothing more, finishes what it holds, hands over its results and ends. Nothing "
      "that "
      "it has computed is lost.");
  app.add_option("WORKER", options->worker,
                 "A worker (16 hex digits), HOST/PROCESS, or HOST for all workers of that host")
      ->required();
  add_connection_options(app, options->connection);
  app.footer("Example\n  lamprey workers\n  lamprey drain node7.lab/3127");
  return [options](const Context& context) { return drain(*options, context); };
}

}  // namespace lamprey::client::commands
