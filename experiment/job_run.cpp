#include "experiment/job_run.hpp"

#include "experiment/models.hpp"
#include "experiment/schedule.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace lamprey::experiment {

namespace {

using namespace science;

double share_of(const Parameters& parameters, std::string_view name) {
  return static_cast<double>(parameters.integer(name)) / 100;
}

evolution::Training training_of(const Job& job, const evolution::Problem& problem) {
  const fitness::Environment surroundings = environment(job.parameters);
  return {.problem = problem,
          .environment = surroundings,
          .objective = job.parameters.choice("objective") == "maximise" ? evolution::Objective::maximise
                                                                        : evolution::Objective::target,
          .expected = problem.expected(surroundings),
          .stream = random::Stream(stream_key(job))};
}

}  // namespace

fitness::Environment environment(const Parameters& parameters) {
  // The biped's fitness has no weights (eq. 6.4).
  if (parameters.choice("robot") == "biped") return {};
  const auto ground = [&](std::string_view leg) {
    return static_cast<std::int16_t>(parameters.integer("ground_level_" + std::string(leg)));
  };
  return {.weights = {.stability = share_of(parameters, "required_stability"),
                      .distance = share_of(parameters, "required_distance"),
                      .fuel = share_of(parameters, "required_fuel")},
          .terrain = {.push_factor = parameters.real("push_factor"),
                      .ground_level = {ground("front_left"), ground("front_right"), ground("back_left"),
                                       ground("back_right")}}};
}

JobRun::JobRun(const Job& job, robots::Machine* machine, NotBegun /*tag*/)
    : problem_(make_problem(job.parameters, machine)),
      training_(training_of(job, *problem_)),
      trainer_(make_trainer(job.parameters, *problem_, training_.stream)),
      recorder_(job.parameters.choice("record") == "details"),
      cycles_(static_cast<std::uint32_t>(job.parameters.integer("cycles"))),
      on_a_robot_(on_a_robot(job.parameters)) {
  if (on_a_robot_ && machine == nullptr) throw std::invalid_argument("robot is 'bridge', and here is no robot");
  Parameters changing = job.parameters;
  if (changing.applies(parameter_index("environment"))) {
    for (const EnvironmentChange& change : parse_schedule(changing.choice("environment"))) {
      for (const auto& [row, value] : change.values) changing.set(row, value);
      changes_.push_back({.cycle = change.cycle, .environment = experiment::environment(changing)});
    }
  }
}

JobRun::JobRun(const Job& job, robots::Machine* machine) : JobRun(job, machine, NotBegun{}) {
  const fitness::Fitness first = trainer_->begin(training_);
  recorder_.begin(training_, first, trainer_->genes());
  finish_if_done();
}

JobRun::JobRun(const Job& job, RunState state) : JobRun(job, nullptr, NotBegun{}) {
  if (state.cycle >= cycles_) {
    throw saving::Invalid("cycle is " + std::to_string(state.cycle) + ", but the job has " + std::to_string(cycles_));
  }
  // A change is met with the first cycle after it.
  while (changes_met_ < changes_.size() && changes_[changes_met_].cycle < state.cycle) ++changes_met_;
  if (changes_met_ > 0) {
    training_.environment = changes_[changes_met_ - 1].environment;
    training_.expected = problem_->expected(training_.environment);
  }
  if (!trainer_->can_be_saved()) throw saving::Invalid("its trainer cannot be saved");
  saving::Reader trainer(state.trainer);
  trainer_->restore(training_, state.cycle, trainer);
  trainer.end();
  saving::Reader recorder(state.recorder);
  recorder_.restore(training_, state.cycle, static_cast<std::uint32_t>(changes_met_), std::move(state.trace), recorder);
  recorder.end();
}

RunState JobRun::save() const {
  saving::Writer trainer;
  trainer_->save(training_, trainer);
  saving::Writer recorder;
  recorder_.save(training_, recorder);
  return {.cycle = recorder_.cycles(),
          .trainer = std::move(trainer).take(),
          .recorder = std::move(recorder).take(),
          .trace = recorder_.outcome().trace};
}

JobRun::JobRun(const JobRun& other)
    : problem_(other.problem_),
      training_(other.training_),
      trainer_(other.trainer_->clone()),
      recorder_(other.recorder_),
      changes_(other.changes_),
      changes_met_(other.changes_met_),
      cycles_(other.cycles_),
      on_a_robot_(other.on_a_robot_) {}

std::uint32_t JobRun::end_of_environment() const {
  return changes_met_ < changes_.size() ? std::min(changes_[changes_met_].cycle, cycles_) : cycles_;
}

void JobRun::meet(const fitness::Environment& environment) {
  training_.environment = environment;
  training_.expected = problem_->expected(environment);
  recorder_.change_environment(training_, trainer_->meet(training_));
}

void JobRun::advance(std::uint32_t most_cycles) {
  if (finished()) return;
  if (recorder_.cycles() == end_of_environment()) meet(changes_[changes_met_++].environment);
  reports_.clear();
  const std::uint32_t budget = std::min(end_of_environment() - recorder_.cycles(), most_cycles);
  trainer_->advance(training_, budget, reports_);
  recorder_.record(training_, reports_, trainer_->genes());
  finish_if_done();
}

void JobRun::finish_if_done() {
  if (finished()) recorder_.finish(trainer_->measures());
}

std::variant<Outcome, Interrupted> run_job(const Job& job, const std::stop_token& stop) {
  // Between two looks at the stop token: short enough to stop at once, long enough to cost nothing.
  constexpr std::uint32_t cycles_between_looks = 64;
  if (stop.stop_requested()) return Interrupted{};
  JobRun run(job);
  while (!run.finished()) {
    if (stop.stop_requested()) return Interrupted{};
    const std::uint32_t begin = run.outcome().cycles;
    while (!run.finished() && run.outcome().cycles - begin < cycles_between_looks) run.advance();
  }
  return std::move(run).take();
}

Score evaluate_preset(const Parameters& parameters) {
  const auto problem = make_problem(parameters);
  const fitness::Environment surroundings = environment(parameters);
  const auto preset = problem->preset();
  evolution::Body standing;
  return scored(preset.empty() ? problem->expected(surroundings) : problem->evaluate(preset, surroundings, standing),
                surroundings.weights);
}

}  // namespace lamprey::experiment
