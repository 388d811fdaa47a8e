#include "client/commands/commands.hpp"
#include "client/failure.hpp"
#include "client/follow.hpp"
#include "client/json.hpp"
#include "client/option_checks.hpp"
#include "client/output/formatting.hpp"
#include "client/output/progress.hpp"
#include "client/output/results_table.hpp"
#include "client/results_source.hpp"
#include "storage/results_reader.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string sweep;
  std::uint64_t job = 0;
  bool follow = false;
  bool quiet = false;
  std::string database;
  ConnectionOptions connection{.join = {}, .timeout_seconds = 5, .file_would_do = true};
};

/// What is known of the job beside the rows.
struct JobState {
  std::string state;
  std::uint64_t cycle = 0;
  std::uint64_t cycles = 0;
};

constexpr std::array<std::string_view, 5> columns = {"cycle", "stability", "distance", "fuel", "total"};

bool has_ended(const std::string& state) {
  return state == "done" || state == "failed" || state == "quarantined" || state == "cancelled";
}

/// Writes rows as they come.
class TraceOutput {
 public:
  TraceOutput(const Options& options, const Context& context) : options_(options), context_(context) {}

  /// Rows that are new, and the job's state now.
  void add(const std::vector<experiment::AcceptedChange>& rows, const JobState& job) {
    job_ = job;
    for (const auto& row : rows) write(row);
    count_ += rows.size();
    if (options_.follow && context_.format == Format::json && (!rows.empty() || has_ended(job.state))) {
      print_line(context_.console, document_of_rows());
      rows_ = Json::array();
    }
    context_.console.out.flush();
  }

  void finish() {
    const auto& console = context_.console;
    if (context_.format == Format::json) {
      if (!options_.follow) print(console, document_of_rows());
    } else if (context_.format == Format::table) {
      std::string summary = "job " + std::to_string(options_.job) + " of " + options_.sweep + ": " + job_.state;
      if (job_.cycles > 0) {
        summary += ", " + output::with_thousands(job_.cycle) + " of " + output::counted(job_.cycles, "cycle", "cycles");
      }
      console.out << (count_ > 0 ? "\n" : "")
                  << console.dim(summary + ", " + output::counted(count_, "change", "changes") + " accepted") << '\n';
    } else if (count_ == 0) {
      write_heading();
    }
  }

 private:
  void write(const experiment::AcceptedChange& row) {
    const auto& score = row.score;
    if (context_.format == Format::json) {
      Json json = {{"cycle", row.cycle}};
      json.update(as_json(score));
      rows_.push_back(std::move(json));
      return;
    }
    write_heading();
    const std::array<double, 4> values = {score.stability, score.distance, score.fuel, score.total};
    std::vector<std::string> cells = {std::to_string(row.cycle)};
    const bool csv = context_.format == Format::csv;
    for (const double value : values) cells.push_back(csv ? output::shortest(value) : output::rounded(value));
    write_line(cells);
  }

  void write_heading() {
    if (begun_) return;
    begun_ = true;
    write_line({columns.begin(), columns.end()});
    if (context_.format == Format::csv) return;
    std::string rule;
    for (std::size_t i = 0; i < columns.size() * (width + 2) - 2; ++i) rule += context_.console.unicode ? "─" : "-";
    context_.console.out << context_.console.dim(rule) << '\n';
  }

  void write_line(const std::vector<std::string>& cells) {
    if (context_.format == Format::csv) {
      context_.console.out << output::csv_line(cells);
      return;
    }
    // Rows come one by one: the columns cannot wait for the widest.
    std::string line;
    for (const auto& cell : cells) {
      line += (line.empty() ? "" : "  ") + std::string(width - std::min(width, cell.size()), ' ') + cell;
    }
    context_.console.out << line << '\n';
  }

  Json document_of_rows() const {
    Json json = document("trace");
    json["sweep"] = options_.sweep;
    json["job"] = options_.job;
    json["state"] = job_.state;
    json["cycle"] = job_.cycle;
    json["cycles"] = job_.cycles;
    json["rows"] = rows_;
    return json;
  }

  static constexpr std::size_t width = 10;
  const Options& options_;
  const Context& context_;
  JobState job_;
  bool begun_ = false;
  std::size_t count_ = 0;
  Json rows_ = Json::array();
};

ExitCode trace_of_database(const Options& options, const Context& context) {
  const storage::ResultsReader reader(options.database);
  const auto sweep = require_sweep(reader, options.database, options.sweep);
  const auto job = reader.job(sweep.row, options.job);
  if (!job) {
    throw Failure(exit_usage, "no_such_job",
                  "job " + std::to_string(options.job) + " of sweep " + sweep.what.name +
                      (options.job < sweep.what.jobs ? " has not ended" : " does not exist"));
  }
  TraceOutput output(options, context);
  JobState state{.state = storage::to_text(job->state)};
  std::vector<experiment::AcceptedChange> rows;
  if (job->outcome) {
    state.cycle = state.cycles = job->outcome->cycles;
    rows = job->outcome->trace;
  }
  output.add(rows, state);
  output.finish();
  return exit_ok;
}

std::vector<experiment::AcceptedChange> rows_of(const idl::TraceReply& trace) {
  std::vector<experiment::AcceptedChange> rows;
  for (const auto& row : trace.rows()) {
    rows.push_back(
        {.cycle = static_cast<std::uint32_t>(row.cycle()),
         .score = {
             .stability = row.stability(), .distance = row.distance(), .fuel = row.fuel(), .total = row.total()}});
  }
  return rows;
}

ExitCode trace_of_coordinator(const Options& options, const Context& context) {
  constexpr std::chrono::milliseconds pause{500};
  CoordinatorConnection connection(context.environment, options.connection);
  TraceOutput output(options, context);
  output::ProgressDisplay display(context.console, options.quiet || !options.follow);
  std::uint64_t next_row = 0;
  const auto ask = [&] {
    idl::Request request;
    request.mutable_trace()->set_sweep(options.sweep);
    request.mutable_trace()->set_job(options.job);
    request.mutable_trace()->set_first_row(next_row);
    return request;
  };
  const auto take = [&](const idl::Reply& reply) -> std::optional<Clock::duration> {
    const auto& trace = reply.trace();
    const auto rows = rows_of(trace);
    next_row += rows.size();
    display.clear();
    output.add(rows, {.state = trace.state(), .cycle = trace.cycle(), .cycles = trace.cycles()});
    if (trace.more() && !rows.empty()) return Clock::duration{};
    if (!options.follow || has_ended(trace.state())) return std::nullopt;
    display.show("job " + std::to_string(options.job) + " of " + options.sweep + "  " + trace.state() + "  cycle " +
                     output::with_thousands(trace.cycle()) + " / " + output::with_thousands(trace.cycles()),
                 Clock::now());
    return pause;
  };
  follow(connection, {.ask = ask, .take = take});
  display.clear();
  output.finish();
  return exit_ok;
}

ExitCode trace(const Options& options, const Context& context) {
  if (options.database.empty()) return trace_of_coordinator(options, context);
  if (options.follow) {
    throw usage_failure(
        "trace: a database has jobs that have ended; --follow asks the coordinator, without --database");
  }
  return trace_of_database(options, context);
}

}  // namespace

Action declare_trace(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Shows the accepted changes of one job, cycle by cycle. The coordinator also knows those of a job that is still "
      "running, up to its newest checkpoint.");
  app.add_option("SWEEP", options->sweep, "Name or id")->required();
  app.add_option("JOB", options->job, "Its number")
      ->required()
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()));
  app.add_flag("--follow", options->follow, "Show new rows as they come, until the job ends");
  app.add_flag("-q,--quiet", options->quiet, "No progress while following");
  app.add_option("--database", options->database, "Read this database file")->type_name("FILE");
  add_connection_options(app, options->connection);
  app.footer("Example\n  lamprey trace quickstart 7 --database results.db --format csv");
  return [options](const Context& context) { return trace(*options, context); };
}

}  // namespace lamprey::client::commands
