#include "client/commands/commands.hpp"
#include "client/coordinator_connection.hpp"
#include "client/failure.hpp"
#include "client/json.hpp"
#include "client/option_checks.hpp"
#include "client/output/formatting.hpp"
#include "client/output/table.hpp"
#include "client/results_source.hpp"
#include "experiment/batch_engine.hpp"
#include "experiment/models.hpp"
#include "experiment/sweep.hpp"
#include "messaging/program/build_info.hpp"
#include "storage/results_reader.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string sweep;
  std::uint64_t job = 0;
  std::string database;
  ConnectionOptions connection{.join = {}, .timeout_seconds = 5, .file_would_do = true};
};

/// What is stored of a job, wherever it came from.
struct Stored {
  idl::SweepSpecification specification;
  std::string name;
  std::uint32_t science_version = 0;
  std::string state;
  std::string reason;  ///< why it failed, where that is known
  std::optional<experiment::Digest> digest;
  std::string build;  ///< of the worker that computed it; empty if it is not known
};

Stored stored_in_database(const Options& options) {
  const storage::ResultsReader reader(options.database);
  const auto sweep = require_sweep(reader, options.database, options.sweep);
  Stored stored;
  stored.name = sweep.what.name;
  stored.science_version = sweep.science_version;
  if (!stored.specification.ParseFromString(sweep.what.specification)) {
    throw storage::StorageError(storage::StorageError::Kind::corrupt,
                                options.database + ": the specification of sweep " + stored.name + " is unreadable");
  }
  const auto job = reader.job(sweep.row, options.job);
  if (!job) {
    throw Failure(exit_usage, "no_such_job",
                  "job " + std::to_string(options.job) + " of sweep " + stored.name +
                      (options.job < sweep.what.jobs
                           ? " has not ended"
                           : " does not exist: its jobs are 0 to " + std::to_string(sweep.what.jobs - 1)));
  }
  stored.state = storage::to_text(job->state);
  stored.reason = job->reason;
  stored.digest = job->digest;
  stored.build = reader.build_of(job->worker).value_or("");
  return stored;
}

Stored stored_at_coordinator(const Options& options, const Environment& environment) {
  CoordinatorConnection connection(environment, options.connection);
  idl::Request request;
  request.mutable_stored_job()->set_sweep(options.sweep);
  request.mutable_stored_job()->set_job(options.job);
  const auto reply = connection.ask_for_success(request);
  Stored stored;
  stored.specification = reply.stored_job().specification();
  stored.name = stored.specification.name();
  stored.science_version = reply.stored_job().science_version();
  stored.state = reply.stored_job().state();
  stored.digest = experiment::digest_from_hex(reply.stored_job().digest());
  stored.build = reply.stored_job().build();
  return stored;
}

/// What can't be compared is refused, with the reason.
void require_comparable(const Stored& stored, std::uint64_t job) {
  const std::string which = "job " + std::to_string(job) + " of sweep " + stored.name;
  if (stored.science_version != experiment::science_version) {
    throw Failure(exit_usage, "other_science",
                  which + " was computed under science version " + std::to_string(stored.science_version) +
                      "; this program computes version " + std::to_string(experiment::science_version) +
                      ", whose outcomes differ");
  }
  if (stored.state != "done" || !stored.digest) {
    throw Failure(exit_usage, "no_outcome",
                  which + " has no outcome to compare with: it is " + stored.state +
                      (stored.reason.empty() ? "" : " (" + stored.reason + ")"));
  }
}

/// Other bits of a job that only the same build repeats say nothing where another build, or none that is known, has
/// computed it.
void require_same_build(const Stored& stored, const experiment::Job& job) {
  const auto repeatability = experiment::repeatability(job.parameters);
  const std::string build = messaging::program::build();
  if (repeatability != experiment::Repeatability::same_build || stored.build == build) return;
  throw Failure(exit_usage, "other_build",
                "job " + std::to_string(job.number) + " of sweep " + stored.name + " was computed by " +
                    (stored.build.empty() ? "a build that is not known" : "build " + stored.build) + "; this is " +
                    build + ", and its trainer gives the same bits only within one build");
}

struct Computed {
  experiment::Outcome outcome;
  experiment::Digest digest{};
  double seconds = 0;
};

Computed compute(const experiment::Job& job) {
  const auto engine = experiment::make_scalar_engine();
  auto results = engine->run({&job, 1}, {});
  auto& result = results.front();
  if (const auto* failure = std::get_if<experiment::Failure>(&result.result)) {
    throw Failure(exit_failure, "job_failed", "job " + std::to_string(job.number) + " fails: " + failure->reason);
  }
  Computed computed{std::get<experiment::Outcome>(std::move(result.result)), {}, result.seconds};
  computed.digest = experiment::outcome_digest(result.identity, computed.outcome);
  return computed;
}

/// The first of them; a run that records details has thousands.
void print_measures(const output::Console& console, std::span<const experiment::Measure> measures) {
  constexpr std::size_t most = 20;
  if (measures.empty()) return;
  console.out << '\n';
  output::Table table({{"measure"}, {"index", output::Align::right}, {"value", output::Align::right}});
  for (const auto& measure : measures.first(std::min(most, measures.size()))) {
    table.add({measure.name, output::with_thousands(measure.index), output::shortest(measure.value)});
  }
  table.print(console);
  if (measures.size() > most) {
    console.out << "and " << output::with_thousands(measures.size() - most) << " more (--format json has all)\n";
  }
}

void print_table(const output::Console& console, const Stored& stored, const experiment::Job& job,
                 const Computed& computed, bool same) {
  output::print_pairs(console,
                      {{"sweep", stored.name},
                       {"job", output::with_thousands(job.number)},
                       {"stored", experiment::to_hex(*stored.digest)},
                       {"computed", experiment::to_hex(computed.digest) + (same ? "  the same" : "  DIFFERENT")},
                       {"accepted", output::with_thousands(computed.outcome.accepted) + " of " +
                                        output::counted(computed.outcome.cycles, "mutation", "mutations")},
                       {"seconds", output::rounded(computed.seconds)}});
  console.out << '\n';
  using output::Align;
  output::Table table({{"computed fitness"},
                       {"stability", Align::right},
                       {"distance", Align::right},
                       {"fuel", Align::right},
                       {"total", Align::right}});
  const auto add = [&](const char* name, const experiment::Score& score) {
    table.add({name, output::shortest(score.stability), output::shortest(score.distance), output::shortest(score.fuel),
               output::shortest(score.total)});
  };
  add("expected", computed.outcome.expected);
  add("initial", computed.outcome.initial);
  add("evolved", computed.outcome.evolved);
  add("highest", computed.outcome.highest);
  add("final", computed.outcome.final);
  table.print(console);
  print_measures(console, computed.outcome.measures);
}

Json measures_of(const experiment::Outcome& outcome) {
  Json all = Json::array();
  for (const auto& measure : outcome.measures) {
    all.push_back({{"name", measure.name}, {"index", measure.index}, {"value", measure.value}});
  }
  return all;
}

Json json_of(const Stored& stored, const experiment::Job& job, const Computed& computed, bool same) {
  const auto& outcome = computed.outcome;
  Json json = document("replay");
  json["sweep"] = stored.name;
  json["job"] = job.number;
  json["same"] = same;
  json["stored_digest"] = experiment::to_hex(*stored.digest);
  json["computed_digest"] = experiment::to_hex(computed.digest);
  json["parameters"] = as_json(job.parameters);
  json["outcome"] = {{"expected", as_json(outcome.expected)}, {"initial", as_json(outcome.initial)},
                     {"evolved", as_json(outcome.evolved)},   {"highest", as_json(outcome.highest)},
                     {"final", as_json(outcome.final)},       {"cycles", outcome.cycles},
                     {"accepted", outcome.accepted},          {"successes", outcome.successes},
                     {"success_rate", outcome.success_rate},  {"measures", measures_of(outcome)}};
  json["seconds"] = computed.seconds;
  return json;
}

ExitCode replay(const Options& options, const Context& context) {
  const Stored stored =
      options.database.empty() ? stored_at_coordinator(options, context.environment) : stored_in_database(options);
  require_comparable(stored, options.job);
  const experiment::SweepGrid grid(stored.specification);
  if (options.job >= grid.jobs()) {
    throw Failure(exit_usage, "no_such_job",
                  "job " + std::to_string(options.job) + " of sweep " + stored.name + " does not exist");
  }
  const auto job = grid.job(options.job);
  const Computed computed = compute(job);
  const bool same = computed.digest == *stored.digest;
  if (!same) require_same_build(stored, job);
  if (context.format == Format::json) {
    print(context.console, json_of(stored, job, computed, same));
  } else {
    print_table(context.console, stored, job, computed, same);
  }
  return same ? exit_ok : exit_mismatch;
}

}  // namespace

Action declare_replay(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Computes a stored job again with the plain, scalar engine and compares the outcome's digest with the stored "
      "one: "
      "equal digests, equal bits, trace included. Without --database the coordinator is asked. Ends with exit code 5 "
      "if "
      "they differ.");
  app.add_option("SWEEP", options->sweep, "Name or id")->required();
  app.add_option("JOB", options->job, "Number of the job within the sweep, from 0 on")
      ->required()
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()));
  app.add_option("--database", options->database, "Read this database file")->type_name("FILE");
  add_connection_options(app, options->connection);
  return [options](const Context& context) { return replay(*options, context); };
}

}  // namespace lamprey::client::commands
