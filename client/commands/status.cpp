#include "client/commands/commands.hpp"
#include "client/coordinator_connection.hpp"
#include "client/json.hpp"
#include "client/output/formatting.hpp"
#include "client/views/sweeps.hpp"
#include "client/views/workers.hpp"

#include <memory>
#include <string>
#include <vector>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string sweep;
  bool all = false;
  ConnectionOptions connection;
};

using Sweeps = std::vector<const idl::SweepStatus*>;

Json json_of(const idl::StatusReply& status, const Sweeps& sweeps) {
  Json json = document("status");
  json["database"] = status.database();
  json["database_id"] = status.database_id();
  json["epoch"] = status.epoch();
  json["storage_fault"] = status.storage_fault().empty() ? Json(nullptr) : Json(status.storage_fault());
  json["sweeps"] = Json::array();
  for (const auto* sweep : sweeps) json["sweeps"].push_back(views::sweep_json(*sweep, status.workers_size()));
  json["workers"] = views::workers_json(status);
  return json;
}

void print_text(const output::Console& console, const idl::StatusReply& status, const Sweeps& sweeps, bool details) {
  console.out << console.dim("database") << "  " << status.database() << "\n\n";
  const auto archived = static_cast<std::size_t>(status.sweeps_size()) - sweeps.size();
  if (!sweeps.empty()) {
    views::print_sweeps(console, sweeps, details);
  } else if (archived == 0) {
    console.out << "No sweeps yet: lamprey submit FILE\n";
  }
  if (archived > 0) {
    console.out << console.dim(output::counted(archived, "archived sweep", "archived sweeps") + ": --all") << '\n';
  }
  console.out << '\n';
  views::print_workers(console, status);
}

ExitCode status(const Options& options, const Context& context) {
  CoordinatorConnection connection(context.environment, options.connection);
  idl::Request request;
  request.mutable_status()->set_sweep(options.sweep);
  const auto reply = connection.ask_for_success(request);
  const auto& status = reply.status();
  const auto sweeps = views::shown_sweeps(status, options.all || !options.sweep.empty());
  views::print_alarms(context.console, status);
  if (context.format == Format::json) {
    print(context.console, json_of(status, sweeps));
  } else {
    print_text(context.console, status, sweeps, !options.sweep.empty());
  }
  return views::divergent_or_ok(sweeps);
}

}  // namespace

Action declare_status(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Shows the coordinator's database, its sweeps with their jobs by state, and its workers. Of one sweep also how "
      "it "
      "is run. Ends with 5 if a job of a sweep that is shown has been computed twice with different outcomes.");
  app.add_option("SWEEP", options->sweep, "Only this sweep, by name or id");
  app.add_flag("--all", options->all, "Archived sweeps too");
  add_connection_options(app, options->connection);
  return [options](const Context& context) { return status(*options, context); };
}

}  // namespace lamprey::client::commands
