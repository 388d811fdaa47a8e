#include "client/commands/commands.hpp"
#include "client/coordinator_connection.hpp"
#include "client/json.hpp"
#include "client/output/formatting.hpp"
#include "client/output/table.hpp"
#include "client/sweep_summary.hpp"
#include "client/sweep_watch.hpp"

#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string sweep;
  ConnectionOptions connection;
};

Json json_of(const idl::StatusReply& status) {
  Json json = document("status");
  json["database"] = status.database();
  json["database_id"] = status.database_id();
  json["epoch"] = status.epoch();
  json["sweeps"] = Json::array();
  for (const auto& sweep : status.sweeps()) {
    Json row = Json::object();
    add_sweep(row, progress_of(sweep, status.workers_size()));
    row["jobs_per_second"] = sweep.jobs_per_second();
    row["seconds_left"] = sweep.has_seconds_left() ? Json(sweep.seconds_left()) : Json(nullptr);
    json["sweeps"].push_back(std::move(row));
  }
  json["workers"] = Json::array();
  for (const auto& worker : status.workers()) {
    json["workers"].push_back({{"worker", worker.worker()},
                               {"host", worker.host()},
                               {"process", worker.process()},
                               {"threads", worker.threads()},
                               {"state", worker.state()},
                               {"dds", worker.dds()},
                               {"jobs_done", worker.jobs_done()},
                               {"leases", worker.leases()}});
  }
  return json;
}

void print_sweeps(const output::Console& console, const idl::StatusReply& status) {
  if (status.sweeps().empty()) {
    console.out << "No sweeps yet: lamprey submit FILE\n";
    return;
  }
  using output::Align;
  output::Table table({{"sweep"},
                       {"state"},
                       {"jobs", Align::right},
                       {"done", Align::right},
                       {"failed", Align::right},
                       {"quarantined", Align::right},
                       {"cancelled", Align::right},
                       {"leased", Align::right},
                       {"pending", Align::right},
                       {"rate", Align::right},
                       {"left", Align::right}});
  for (const auto& sweep : status.sweeps()) {
    const auto& counts = sweep.counts();
    const bool runs = sweep.state() == "running";
    table.add({sweep.name(), sweep.state(), output::with_thousands(counts.jobs()),
               output::with_thousands(counts.done()), output::with_thousands(counts.failed()),
               output::with_thousands(counts.quarantined()), output::with_thousands(counts.cancelled()),
               output::with_thousands(counts.leased()), output::with_thousands(counts.pending()),
               runs ? output::rate(sweep.jobs_per_second()) : "",
               runs && sweep.has_seconds_left() ? output::duration(sweep.seconds_left()) : ""});
    if (sweep.divergences() > 0) {
      table.note(output::counted(sweep.divergences(), "result diverges", "results diverge") +
                 " from what is stored: see the table divergence");
    }
  }
  table.print(console);
}

void print_workers(const output::Console& console, const idl::StatusReply& status) {
  console.out << '\n';
  if (status.workers().empty()) {
    console.out << "No workers: start lamprey-worker on any machine.\n";
    return;
  }
  using output::Align;
  output::Table table({{"worker"},
                       {"host"},
                       {"process", Align::right},
                       {"threads", Align::right},
                       {"state"},
                       {"DDS"},
                       {"jobs done", Align::right},
                       {"leases", Align::right}});
  for (const auto& worker : status.workers()) {
    table.add({worker.worker(), worker.host(), std::to_string(worker.process()), std::to_string(worker.threads()),
               worker.state(), worker.dds(), output::with_thousands(worker.jobs_done()),
               output::with_thousands(worker.leases())});
  }
  table.print(console);
}

ExitCode status(const Options& options, const Context& context) {
  CoordinatorConnection connection(context.environment, options.connection);
  idl::Request request;
  request.mutable_status()->set_sweep(options.sweep);
  const auto reply = connection.ask_for_success(request);
  if (context.format == Format::json) {
    print(context.console, json_of(reply.status()));
    return exit_ok;
  }
  context.console.out << context.console.dim("database") << "  " << reply.status().database() << "\n\n";
  print_sweeps(context.console, reply.status());
  print_workers(context.console, reply.status());
  return exit_ok;
}

}  // namespace

Action declare_status(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description("Shows the coordinator's database, its sweeps with their jobs by state, and its workers.");
  app.add_option("SWEEP", options->sweep, "Only this sweep, by name or id");
  add_connection_options(app, options->connection);
  return [options](const Context& context) { return status(*options, context); };
}

}  // namespace lamprey::client::commands
