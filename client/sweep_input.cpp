#include "client/sweep_input.hpp"

#include "client/coordinator_connection.hpp"
#include "client/option_checks.hpp"
#include "client/output/formatting.hpp"
#include "experiment/execution_validation.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

namespace lamprey::client {

namespace {

/// What the command line says may be wrong in itself, or not go with the file.
void apply(const SweepOverrides& overrides, idl::SweepSpecification& specification) {
  if (!overrides.name.empty()) specification.set_name(overrides.name);
  if (overrides.priority) specification.mutable_execution()->set_priority(*overrides.priority);
  if (overrides.fail_fast) specification.mutable_execution()->set_fail_fast(true);
  for (const auto& tag : overrides.tags) {
    const auto& tags = specification.execution().tags();
    if (std::ranges::find(tags, tag) == tags.end()) specification.mutable_execution()->add_tags(tag);
  }
  if (auto problems = experiment::validate(specification); !problems.empty()) {
    throw experiment::InvalidInput(std::move(problems));
  }
}

}  // namespace

void add_sweep_overrides(CLI::App& app, SweepOverrides& overrides) {
  app.add_option("--name", overrides.name, "Another name than the file's")->type_name("NAME");
  app.add_option("--priority", overrides.priority, "Another priority than the file's: higher ones are served first")
      ->type_name("N")
      ->check(whole_number_between(experiment::minimum_priority, experiment::maximum_priority));
  app.add_option("--tag", overrides.tags, "A tag beside the file's; repeatable")
      ->type_name("TAG")
      ->allow_extra_args(false);
  app.add_flag("--fail-fast", overrides.fail_fast, "End the sweep with its first failed or quarantined job");
  app.add_flag("--fresh", overrides.fresh, "Compute every job, also those whose outcome the database has");
}

SweepInput read_sweep(const std::string& path, const SweepOverrides& overrides) {
  SweepInput sweep;
  sweep.path = path;
  sweep.file = experiment::read_sweep_file(path);
  std::ifstream text(path, std::ios::binary);
  sweep.source.assign(std::istreambuf_iterator<char>(text), {});
  apply(overrides, sweep.file.specification);
  sweep.fresh = overrides.fresh;
  sweep.id = experiment::sweep_id(sweep.file.specification);
  return sweep;
}

idl::Request submit_request(const SweepInput& sweep) {
  idl::Request request;
  *request.mutable_submit()->mutable_specification() = sweep.file.specification;
  request.mutable_submit()->set_source(sweep.source);
  request.mutable_submit()->set_fresh(sweep.fresh);
  return request;
}

idl::Request status_request(const SweepInput& sweep) {
  idl::Request request;
  request.mutable_status()->set_sweep(experiment::to_hex(sweep.id));
  return request;
}

std::string reused_text(std::uint64_t outcomes) {
  return output::counted(outcomes, "outcome", "outcomes") +
         " that the database had already (--fresh computes them again)";
}

Failure sweep_changed(const std::string& name, std::vector<std::string> differences) {
  return {exit_usage,
          "sweep_changed",
          {"sweep '" + name +
           "' is in the database with another specification; give this one another name (--name NAME), or take another "
           "database:"},
          std::move(differences)};
}

void require_accepted(const idl::Reply& reply, const SweepInput& sweep) {
  if (reply.has_error() && reply.error().code() == "sweep_changed") {
    throw sweep_changed(sweep.name(), {reply.error().messages().begin(), reply.error().messages().end()});
  }
  if (!reply.has_error() || reply.error().code() != "invalid_specification") {
    require_success(reply);
    return;
  }
  std::vector<experiment::Problem> problems;
  for (int i = 0; i < reply.error().messages_size(); ++i) {
    experiment::Problem problem{.field = {}, .message = reply.error().messages(i), .file = sweep.path};
    if (i < reply.error().fields_size()) problem.field = reply.error().fields(i);
    if (const auto place = sweep.file.positions.find(problem.field); place != sweep.file.positions.end()) {
      problem.line = place->second.line;
      problem.column = place->second.column;
    }
    problems.push_back(std::move(problem));
  }
  if (problems.empty()) require_success(reply);
  throw experiment::InvalidInput(std::move(problems));
}

}  // namespace lamprey::client
