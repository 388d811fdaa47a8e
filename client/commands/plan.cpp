#include "client/commands/commands.hpp"
#include "client/json.hpp"
#include "client/output/formatting.hpp"
#include "client/output/table.hpp"
#include "client/sweep_input.hpp"

#include <algorithm>
#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

using experiment::SweepGrid;

struct Options {
  std::string file;
};

/// A value; an environment that never changes has no text of its own.
std::string shown(const experiment::Value& value) {
  const std::string text = experiment::to_text(value);
  return text.empty() ? "none" : text;
}

std::string parameter_name(const SweepGrid::Axis& axis) {
  return std::string(experiment::registry()[axis.parameter].name);
}

/// Mutations that all jobs of one replicate try: the sum over the cells of a grid is its cells times the mean of its
/// axis of cycles, or times the one value that all its cells have.
std::uint64_t cycles_of_one_replicate(const SweepGrid& grid) {
  const std::size_t cycles_row = experiment::parameter_index("cycles");
  std::uint64_t sum = 0;
  std::uint64_t first_cell = 0;
  for (const auto& part : grid.grids()) {
    const auto axis = std::ranges::find(part.axes, cycles_row, &SweepGrid::Axis::parameter);
    if (axis == part.axes.end()) {
      sum += part.cells * static_cast<std::uint64_t>(grid.job(first_cell).parameters.integer("cycles"));
    } else {
      for (const auto& value : axis->values) {
        sum += part.cells / axis->values.size() * static_cast<std::uint64_t>(std::get<std::int64_t>(value));
      }
    }
    first_cell += part.cells;
  }
  return sum;
}

Json json_of(const experiment::Job& job) {
  return {{"number", job.number}, {"replicate", job.replicate}, {"parameters", as_json(job.parameters)}};
}

Json json_of(const SweepInput& sweep, const SweepGrid& grid, std::uint64_t cycles) {
  const auto& specification = sweep.file.specification;
  Json json = document("plan");
  json["file"] = sweep.path;
  json["sweep"] = sweep.name();
  json["id"] = experiment::to_hex(sweep.id);
  json["description"] = specification.description();
  json["seed"] = specification.seed();
  json["jobs"] = grid.jobs();
  json["cells"] = grid.cells();
  json["replicates"] = grid.replicates();
  json["cycles"] = cycles;
  json["grids"] = Json::array();
  for (const auto& part : grid.grids()) {
    Json axes = Json::array();
    for (const auto& axis : part.axes) {
      Json values = Json::array();
      for (const auto& value : axis.values) values.push_back(as_json(value));
      axes.push_back({{"parameter", parameter_name(axis)}, {"values", std::move(values)}});
    }
    json["grids"].push_back({{"cells", part.cells}, {"axes", std::move(axes)}});
  }
  json["first_job"] = json_of(grid.job(0));
  json["last_job"] = json_of(grid.job(grid.jobs() - 1));
  return json;
}

void print_grid(const output::Console& console, std::size_t number, const SweepGrid::Grid& grid) {
  console.out << '\n'
              << console.bold("Grid " + std::to_string(number) + ": " + output::counted(grid.cells, "cell", "cells"))
              << '\n';
  if (grid.axes.empty()) return;
  output::Table table({{"axis"}, {"values", output::Align::right}, {""}});
  constexpr std::size_t name_and_count = 40;
  for (const auto& axis : grid.axes) {
    std::vector<std::string> values;
    for (const auto& value : axis.values) values.push_back(shown(value));
    table.add({parameter_name(axis), output::with_thousands(values.size()),
               output::list_in_short(values, console.columns - name_and_count, console.ellipsis())});
  }
  table.print(console);
}

void print_jobs(const output::Console& console, const experiment::Job& first, const experiment::Job& last) {
  output::Table table({{"parameter"},
                       {"first job: " + output::with_thousands(first.number)},
                       {"last job: " + output::with_thousands(last.number)}});
  const auto registry = experiment::registry();
  for (std::size_t row = 0; row < registry.size(); ++row) {
    const auto cell = [&](const experiment::Job& job) {
      return job.parameters.applies(row) ? shown(job.parameters[row]) : std::string("-");
    };
    if (!first.parameters.applies(row) && !last.parameters.applies(row)) continue;
    table.add({std::string(registry[row].name), cell(first), cell(last)});
  }
  table.add({"replicate", std::to_string(first.replicate), std::to_string(last.replicate)});
  console.out << '\n';
  table.print(console);
}

ExitCode plan(const Options& options, const Context& context) {
  const SweepInput sweep = read_sweep(options.file);
  const SweepGrid grid(sweep.file.specification);
  const std::uint64_t cycles = cycles_of_one_replicate(grid) * grid.replicates();
  const auto& console = context.console;
  if (context.format == Format::json) {
    print(console, json_of(sweep, grid, cycles));
    return exit_ok;
  }
  const auto& specification = sweep.file.specification;
  std::vector<std::pair<std::string, std::string>> head = {{"sweep", console.bold(sweep.name())}};
  if (!specification.description().empty()) head.emplace_back("description", specification.description());
  head.emplace_back("id", experiment::to_hex(sweep.id));
  head.emplace_back("seed", std::to_string(specification.seed()));
  head.emplace_back("jobs", output::with_thousands(grid.jobs()) + " = " +
                                output::counted(grid.cells(), "cell", "cells") + " x " +
                                output::counted(grid.replicates(), "replicate", "replicates"));
  head.emplace_back("cycles", output::with_thousands(cycles) + " (one evaluation of the robot each)");
  output::print_pairs(console, head);
  for (std::size_t i = 0; i < grid.grids().size(); ++i) print_grid(console, i + 1, grid.grids()[i]);
  print_jobs(console, grid.job(0), grid.job(grid.jobs() - 1));
  return exit_ok;
}

}  // namespace

Action declare_plan(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Reads a sweep file and shows which jobs it stands for: how many, on which axes, and the parameters of the first "
      "and the last one. Runs nothing and changes nothing.");
  app.add_option("FILE", options->file, "Sweep file (YAML)")->required();
  return [options](const Context& context) { return plan(*options, context); };
}

}  // namespace lamprey::client::commands
