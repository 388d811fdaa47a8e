#include "client/sweep_control.hpp"

#include "client/json.hpp"

namespace lamprey::client {

void add_control_options(CLI::App& app, ControlOptions& options) {
  app.add_option("SWEEP", options.sweep, "Name or id")->required();
  add_connection_options(app, options.connection);
}

idl::Request control_request(const std::string& sweep, idl::ControlRequest::Action action) {
  idl::Request request;
  request.mutable_control()->set_sweep(sweep);
  request.mutable_control()->set_action(action);
  return request;
}

idl::ControlReply steer(const ControlOptions& options, const Context& context, const idl::Request& request) {
  CoordinatorConnection connection(context.environment, options.connection);
  return connection.ask_for_success(request).control();
}

void print_control(const Context& context, std::string_view command, const std::string& sweep,
                   const idl::ControlReply& reply, const std::string& text) {
  if (context.format == Format::json) {
    Json json = document(command);
    json["sweep"] = sweep;
    json["state"] = reply.state();
    json["jobs"] = reply.jobs();
    print(context.console, json);
  } else {
    context.console.out << text << '\n';
  }
}

}  // namespace lamprey::client
