#include "science/evolution/trainers/simulated_annealing.hpp"

#include "science/evolution/acceptance.hpp"
#include "science/evolution/operators/word_sequence.hpp"

#include <limits>
#include <utility>

namespace lamprey::science::evolution::trainers {

using operators::WordSequence;
using random::Purpose;

SimulatedAnnealing::SimulatedAnnealing(SimulatedAnnealingSettings settings)
    : OffLine(1, settings.first_genes), settings_(std::move(settings)), temperature_(settings_.first_temperature) {
  require_within("first_step", settings_.first_step, std::numeric_limits<double>::min(), 1000);
  require_within("first_temperature", settings_.first_temperature, 0, std::numeric_limits<double>::max());
  require_within("temperature_factor", settings_.temperature_factor, 0, 1);
  require_within("tries_per_temperature", settings_.tries_per_temperature, 1,
                 std::numeric_limits<std::uint32_t>::max());
}

void SimulatedAnnealing::found(std::vector<Member> first) {
  state_ = std::move(first.front());
}

std::vector<std::vector<double>> SimulatedAnnealing::breed(const Training& training, std::uint32_t generation) {
  const GenePlan& plan = training.problem.plan();
  WordSequence choice(training.stream, generation, Purpose::mutation_choice, 0);
  const std::uint32_t gene = random::bounded(choice.word(0), static_cast<std::uint32_t>(plan.genes.size()));
  WordSequence deviate(training.stream, generation, Purpose::mutation, 0);
  const double step = deviate.normal(0) * settings_.first_step * plan.genes[gene].step_unit;

  std::vector<double> candidate = state_.genes;
  candidate[gene] = held(plan.genes[gene], candidate[gene] + step);
  return {std::move(candidate)};
}

void SimulatedAnnealing::survive(const Training& training, std::uint32_t generation, std::vector<Member> tried) {
  WordSequence words(training.stream, generation, Purpose::acceptance, 0);
  if (metropolis_accepts(tried.front().cost - state_.cost, temperature_, words.unit(0))) {
    state_ = std::move(tried.front());
  }
  if (generation % settings_.tries_per_temperature == 0) temperature_ *= settings_.temperature_factor;
}

void SimulatedAnnealing::save_population(const Training& training, std::uint32_t /*generation*/,
                                         saving::Writer& writer) const {
  fields(writer, training.problem.plan(), state_);
  writer.real("temperature", temperature_);
}

void SimulatedAnnealing::restore_population(const Training& training, std::uint32_t /*generation*/,
                                            saving::Reader& reader) {
  fields(reader, training.problem.plan(), state_);
  saving::real_within(reader, "temperature", temperature_, 0, settings_.first_temperature);
}

}  // namespace lamprey::science::evolution::trainers
