#include "client/commands/commands.hpp"
#include "client/coordinator_connection.hpp"
#include "client/json.hpp"
#include "client/output/formatting.hpp"

#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string sweep;
  ConnectionOptions connection;
};

ExitCode cancel(const Options& options, const Context& context) {
  CoordinatorConnection connection(context.environment, options.connection);
  idl::Request request;
  request.mutable_cancel()->set_sweep(options.sweep);
  const auto reply = connection.ask_for_success(request);
  const std::uint64_t cancelled = reply.cancel().cancelled();
  if (context.format == Format::json) {
    Json json = document("cancel");
    json["sweep"] = options.sweep;
    json["cancelled"] = cancelled;
    print(context.console, json);
  } else {
    context.console.out << "Sweep " << options.sweep << ": " << output::counted(cancelled, "job", "jobs")
                        << (cancelled == 0 ? " cancelled; all had ended.\n" : " cancelled; what had ended is kept.\n");
  }
  return exit_ok;
}

}  // namespace

Action declare_cancel(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Cancels the jobs of a sweep that have not ended. Outcomes that exist are kept; a cancelled sweep does not go on "
      "when it is submitted again.");
  app.add_option("SWEEP", options->sweep, "Name or id")->required();
  add_connection_options(app, options->connection);
  return [options](const Context& context) { return cancel(*options, context); };
}

}  // namespace lamprey::client::commands
