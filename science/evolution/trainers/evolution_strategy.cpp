#include "science/evolution/trainers/evolution_strategy.hpp"

#include "science/evolution/operators/choice.hpp"
#include "science/evolution/operators/crossover.hpp"
#include "science/evolution/operators/normal_steps.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace lamprey::science::evolution::trainers {

using operators::WordSequence;
using random::Purpose;

namespace {

std::uint32_t parents_of(const EvolutionStrategySettings& settings) {
  return settings.strategy == Strategy::one_plus_one ? 1 : settings.population;
}

/// λ.
std::uint32_t children_of(const EvolutionStrategySettings& settings) {
  const bool many = settings.strategy == Strategy::mu_plus_lambda || settings.strategy == Strategy::mu_comma_lambda;
  return many ? settings.offspring : 1;
}

}  // namespace

void require_ordered(const StepSizes& steps) {
  require_within("smallest step", steps.smallest, std::numeric_limits<double>::min(), largest_step);
  require_within("largest step", steps.largest, steps.smallest, largest_step);
  require_within("first step", steps.first, steps.smallest, steps.largest);
}

void mutate_adapted(const GenePlan& plan, const StepSizes& sizes, WordSequence& words, std::vector<double>& genes,
                    double& standard_deviation) {
  const double deviate = words.normal(static_cast<std::uint32_t>(genes.size()));
  standard_deviation = std::clamp(operators::adapted_standard_deviation(standard_deviation, deviate, genes.size()),
                                  sizes.smallest, sizes.largest);
  operators::add_normal_steps(plan, standard_deviation, words, genes);
}

EvolutionStrategy::EvolutionStrategy(EvolutionStrategySettings settings)
    : OffLine(parents_of(settings), settings.first_genes), settings_(std::move(settings)) {
  if (settings_.strategy != Strategy::one_plus_one) {
    require_within("population", settings_.population, smallest_population, largest_population);
    const bool comma = settings_.strategy == Strategy::mu_comma_lambda;
    require_within("offspring", children_of(settings_), comma ? settings_.population : 1, largest_population);
  }
  require_ordered(settings_.steps);
  require_within("success_window", settings_.success_window, 1, std::numeric_limits<std::uint32_t>::max());
  require_within("step_factor", settings_.step_factor, 0.01, 1);
  rule_ = {.first_standard_deviation = settings_.steps.first,
           .window = settings_.success_window,
           .factor = settings_.step_factor,
           .minimum_standard_deviation = settings_.steps.smallest,
           .maximum_standard_deviation = settings_.steps.largest};
  rule_state_ = first_state(rule_);
}

void EvolutionStrategy::found(std::vector<Member> first) {
  for (Member& member : first) parents_.push_back({std::move(member), settings_.steps.first});
}

std::vector<double> EvolutionStrategy::child(const Training& training, std::uint32_t generation, std::uint32_t number) {
  WordSequence choice(training.stream, generation, Purpose::selection, number);
  const auto chosen = operators::choose_distinct(choice, 2, settings_.population);
  const Adapted& mother = parents_[chosen[0]];
  const Adapted& father = parents_[chosen[1]];
  WordSequence mixing(training.stream, generation, Purpose::crossover, number);
  std::vector<double> genes = operators::recombine(mother.member.genes, father.member.genes, mixing);
  double standard_deviation = (mother.standard_deviation + father.standard_deviation) / 2;

  WordSequence steps(training.stream, generation, Purpose::mutation, number);
  mutate_adapted(training.problem.plan(), settings_.steps, steps, genes, standard_deviation);
  children_deviations_.push_back(standard_deviation);
  return genes;
}

std::vector<std::vector<double>> EvolutionStrategy::breed(const Training& training, std::uint32_t generation) {
  if (settings_.strategy == Strategy::one_plus_one) {
    std::vector<double> genes = parents_.front().member.genes;
    WordSequence steps(training.stream, generation, Purpose::mutation, 0);
    operators::add_normal_steps(training.problem.plan(), rule_state_.standard_deviation, steps, genes);
    return {std::move(genes)};
  }
  children_deviations_.clear();
  std::vector<std::vector<double>> next;
  const std::uint32_t children = children_of(settings_);
  for (std::uint32_t number = 0; number < children; ++number) next.push_back(child(training, generation, number));
  return next;
}

void EvolutionStrategy::survive(const Training& /*training*/, std::uint32_t /*generation*/,
                                std::vector<Member> children) {
  if (settings_.strategy == Strategy::one_plus_one) {
    Member& parent = parents_.front().member;
    const bool better = children.front().cost < parent.cost;
    if (better) parent = std::move(children.front());
    return record(rule_, rule_state_, better);
  }
  if (settings_.strategy == Strategy::mu_comma_lambda) parents_.clear();
  for (std::size_t i = 0; i < children.size(); ++i) {
    parents_.push_back({std::move(children[i]), children_deviations_[i]});
  }
  std::ranges::stable_sort(parents_, {}, [](const Adapted& adapted) { return adapted.member.cost; });
  parents_.resize(settings_.population);
}

void EvolutionStrategy::save_population(const Training& training, std::uint32_t /*generation*/,
                                        saving::Writer& writer) const {
  for (const Adapted& parent : parents_) member_fields(writer, training.problem.plan(), parent);
  fields(writer, rule_, rule_state_);
}

void EvolutionStrategy::restore_population(const Training& training, std::uint32_t /*generation*/,
                                           saving::Reader& reader) {
  parents_.resize(parents_of(settings_));
  for (Adapted& parent : parents_) member_fields(reader, training.problem.plan(), parent);
  fields(reader, rule_, rule_state_);
}

}  // namespace lamprey::science::evolution::trainers
