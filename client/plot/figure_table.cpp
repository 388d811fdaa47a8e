#include "client/failure.hpp"
#include "client/option_checks.hpp"
#include "client/plot/figures.hpp"
#include "client/report/findings.hpp"
#include "experiment/parameters.hpp"

#include <algorithm>
#include <array>

namespace lamprey::client::plot {

std::span<const Figure> figure_table() {
  static const std::array rows = {
      Figure{"6-25", "Biped, genetic algorithm: mean fitness against evaluations, recurrent and feed-forward",
             Source::results, fitness_by_network},
      Figure{"6-26", "Biped, genetic algorithm: fitness against the average variation of the parameters",
             Source::results, fitness_against_variation},
      Figure{"6-27", "Biped, genetic algorithm: final fitness against the mutation rate", Source::results,
             fitness_by_mutation_rate},
      Figure{"6-30", "Biped, II-RTEA: mean fitness against evaluations, recurrent and feed-forward", Source::results,
             fitness_by_network},
      Figure{"6-31", "Biped, II-RTEA: fitness against the average variation of the parameters", Source::results,
             fitness_against_variation},
      Figure{"7-17", "Outputs of the recurrent network of eight against the wanted ones", Source::recording,
             outputs_against_wanted},
      Figure{"7-22", "Outputs of the single-mother network against the wanted ones", Source::recording,
             outputs_against_wanted},
      Figure{"8-3", "Mutate all: expected and evolved fitness per steps and acceptance", Source::results,
             operator_bars},
      Figure{"8-4", "Mutate one: the same", Source::results, operator_bars},
      Figure{"8-5", "Mutate some: the same", Source::results, operator_bars},
      Figure{"8-6", "Total over disturbance and mutation size: normal steps, simple acceptance", Source::results,
             disturbance_surfaces},
      Figure{"8-7", "The same: normal steps, annealing", Source::results, disturbance_surfaces},
      Figure{"8-8", "The same: uniform steps, simple acceptance", Source::results, disturbance_surfaces},
      Figure{"8-9", "The same: uniform steps, annealing", Source::results, disturbance_surfaces},
      Figure{"8-10", "1/5 rule: expected and evolved fitness per mutation and acceptance", Source::results,
             operator_bars},
      Figure{"9-5", "Failures before each change of gait, mutate all", Source::results, gait_change_failures},
      Figure{"9-6", "Failures before each change of gait, mutate one", Source::results, gait_change_failures},
      Figure{"fitness", "Total against cycles, of single jobs (--jobs) or averaged (--average-by)", Source::results,
             fitness_of_jobs},
      Figure{"network-output", "Output for each servo of a gait, step by step (fig. 7.26 b, appendix D)",
             Source::recording, network_output},
      Figure{"leg-positions", "Positions of the legs, step by step (fig. 7.26 c)", Source::recording, leg_positions},
      Figure{"side-view", "The robot from its side, at several times (fig. 7.26 d)", Source::recording, side_view},
      Figure{"3d-view", "The robot in space, at several times (fig. 7.26 e)", Source::recording, view_in_space},
  };
  return rows;
}

const Figure* find_figure(std::string_view name) {
  const auto all = figure_table();
  const auto found = std::ranges::find(all, name, &Figure::name);
  return found == all.end() ? nullptr : &*found;
}

void no_data(const Figure& figure, const std::vector<std::string>& sweeps) {
  std::vector<std::string> messages = {"the database has no job for figure " + std::string(figure.name) +
                                       " with these values"};
  for (const auto& sweep : sweeps) messages.push_back("it is drawn from: " + report::run_command(sweep));
  throw Failure(exit_usage, "no_data", std::move(messages));
}

namespace {

bool allows(const Request& request, const Reading& reading) {
  for (const auto& [column, text] : request.settings) {
    for (const auto& [name, literal] : reading.values) {
      if (name == column && literal != json_literal(text) && literal != json_literal(text) + ".0") return false;
    }
  }
  return true;
}

void check_columns(const Request& request) {
  for (const auto& [column, text] : request.settings) {
    if (request.evidence->has_column("result", column)) continue;
    std::vector<std::string_view> known;
    for (const auto& parameter : experiment::registry()) known.push_back(parameter.name);
    throw Failure(exit_usage, "unknown_column", unknown_name("column", column, known));
  }
}

}  // namespace

Reading chosen_reading(const Request& request, const Figure& figure,
                       const std::vector<std::vector<std::string>>& sweeps, const std::vector<std::string>& columns) {
  check_columns(request);
  std::vector<std::vector<std::string>> candidates = sweeps;
  if (request.sweep) {
    if (!request.evidence->has_sweep(*request.sweep)) {
      std::vector<std::string_view> known;
      for (const auto& sweep : request.evidence->sweeps()) known.push_back(sweep.what.name);
      throw Failure(exit_usage, "unknown_sweep", unknown_name("sweep", *request.sweep, known));
    }
    candidates = {{*request.sweep}};
  }
  std::vector<std::string> to_run;
  for (const auto& candidate : candidates) {
    std::vector<std::string> present;
    for (const auto& sweep : candidate) {
      if (request.evidence->has_sweep(sweep)) present.push_back(sweep);
    }
    to_run.push_back(candidate.front());
    if (present.empty()) continue;
    for (auto reading : request.evidence->readings(present, columns)) {
      if (!allows(request, reading)) continue;
      for (const auto& [column, text] : request.settings) {
        const bool known =
            std::ranges::any_of(reading.values, [&name = column](const auto& value) { return value.first == name; });
        if (!known) reading.settings.emplace_back(column, json_literal(text));
      }
      return reading;
    }
  }
  no_data(figure, to_run);
}

}  // namespace lamprey::client::plot
