#include "science/evolution/trainers/ii_rtea.hpp"

#include "science/evolution/operators/uniform_mutation.hpp"

#include <utility>

namespace lamprey::science::evolution::trainers {

IiRtea::IiRtea(IiRteaSettings settings) : settings_(std::move(settings)) {
  require_within("mutation_rate", settings_.mutation_rate, 0, 100);
}

fitness::Fitness IiRtea::evaluate(const Training& training, std::span<const double> genes) {
  if (settings_.posture == Posture::reset) body_.reset();
  return training.problem.evaluate(genes, training.environment, body_);
}

fitness::Fitness IiRtea::begin(const Training& training) {
  accepted_.genes = first_genes(settings_.first_genes, training, 0);
  return meet(training);
}

fitness::Fitness IiRtea::meet(const Training& training) {
  const fitness::Fitness fitness = evaluate(training, accepted_.genes);
  accepted_.cost = cost(training, fitness);
  return fitness;
}

void IiRtea::save(const Training& training, saving::Writer& writer) const {
  fields(writer, training.problem.plan(), accepted_);
  if (settings_.posture == Posture::carry) training.problem.save(body_, writer);
}

void IiRtea::restore(const Training& training, std::uint32_t cycles, saving::Reader& reader) {
  cycle_ = cycles;
  fields(reader, training.problem.plan(), accepted_);
  if (settings_.posture == Posture::carry) training.problem.restore(reader, body_);
}

void IiRtea::advance(const Training& training, std::uint32_t /*budget*/, std::vector<CycleReport>& reports) {
  const GenePlan& plan = training.problem.plan();
  std::vector<double> candidate = accepted_.genes;
  operators::WordSequence choice(training.stream, cycle_, random::Purpose::mutation_choice, 0);
  operators::WordSequence values(training.stream, cycle_, random::Purpose::mutation, 0);
  operators::redraw_some(plan, operators::mutated_count(candidate.size(), settings_.mutation_rate), choice, values,
                         candidate);

  const fitness::Fitness fitness = evaluate(training, candidate);
  const double now = cost(training, fitness);
  const bool better = now < accepted_.cost;
  if (better) accepted_ = {.genes = std::move(candidate), .cost = now};
  ++cycle_;
  reports.push_back({.fitness = fitness, .accepted = better, .success = better});
}

}  // namespace lamprey::science::evolution::trainers
