#include "science/evolution/rtea.hpp"

#include <limits>
#include <utility>

namespace lamprey::science::evolution {

StepDistribution step_distribution(const RteaSettings& settings, Objective objective, const OneFifthState& one_fifth,
                                   const Errors& last_accepted) {
  using enum StepDistribution::Kind;
  if (settings.steps == Steps::uniform) return {.kind = uniform, .size = settings.size};
  if (settings.steps == Steps::one_fifth_rule) {
    return {.kind = normal, .standard_deviation = one_fifth.standard_deviation};
  }
  const double half_size = settings.size / 2.0;
  // Under `maximise` there is no error to take a root of.
  const bool follows_error = settings.step_variance == StepVariance::root_error && objective == Objective::target;
  return {
      .kind = normal,
      .standard_deviation = follows_error ? root_error_standard_deviation(half_size, total(last_accepted)) : half_size};
}

Rtea::Rtea(const RteaSettings& settings, std::vector<double> first_genes) : settings_(settings) {
  state_.genes = std::move(first_genes);
  state_.one_fifth = first_state(settings.one_fifth_rule);
  state_.temperature = settings.temperature;
}

fitness::Fitness Rtea::begin(const Training& training) {
  state_.fitness = training.problem.evaluate(state_.genes, training.environment, state_.body);
  return state_.fitness;
}

fitness::Fitness Rtea::meet(const Training& training) {
  if (settings_.posture == Posture::reset) state_.body.reset();
  return begin(training);
}

namespace {

/// The body lives on under `carry` only; the number of cycles is known.
void fields(auto& archive, const RteaSettings& settings, const GenePlan& plan, saving::Of<RteaState> auto& state) {
  fields(archive, plan, state.genes);
  fields(archive, state.fitness);
  fields(archive, settings.one_fifth_rule, state.one_fifth);
  saving::real_within(archive, "temperature", state.temperature, 0, std::numeric_limits<double>::max());
}

}  // namespace

void Rtea::save(const Training& training, saving::Writer& writer) const {
  fields(writer, settings_, training.problem.plan(), state_);
  if (settings_.posture == Posture::carry) training.problem.save(state_.body, writer);
}

void Rtea::restore(const Training& training, std::uint32_t cycles, saving::Reader& reader) {
  state_.cycle = cycles;
  fields(reader, settings_, training.problem.plan(), state_);
  if (settings_.posture == Posture::carry) training.problem.restore(reader, state_.body);
}

bool Rtea::annealing_accepts(const Training& training, double error_change) const {
  const auto words = training.stream.block(state_.cycle, random::Purpose::acceptance, 0);
  return metropolis_accepts(error_change, state_.temperature, random::unit_interval(words[0], words[1]));
}

void Rtea::advance(const Training& training, std::uint32_t /*budget*/, std::vector<CycleReport>& reports) {
  const Errors before = errors(training, state_.fitness);
  candidate_ = state_.genes;
  mutate(training.stream, state_.cycle, settings_.mutation,
         step_distribution(settings_, training.objective, state_.one_fifth, before), training.problem.plan(),
         candidate_);

  if (settings_.posture == Posture::reset) state_.body.reset();
  CycleReport report{.fitness = training.problem.evaluate(candidate_, training.environment, state_.body)};
  const Errors now = errors(training, report.fitness);

  const Comparison comparison = compare(settings_.criterion, now, before);
  report.success = comparison.better;
  report.accepted = comparison.acceptable;
  if (settings_.acceptance == Acceptance::annealing && !report.accepted) {
    report.accepted = annealing_accepts(training, total(now) - total(before));
  }
  if (report.accepted) {
    state_.genes.swap(candidate_);
    state_.fitness = report.fitness;
  }
  record(settings_.one_fifth_rule, state_.one_fifth, report.success);
  state_.temperature *= settings_.cooling;
  ++state_.cycle;
  reports.push_back(report);
}

}  // namespace lamprey::science::evolution
