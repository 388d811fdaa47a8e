#include "science/evolution/trainers/evolutionary_programming.hpp"

#include "science/evolution/operators/choice.hpp"

#include <algorithm>
#include <utility>

namespace lamprey::science::evolution::trainers {

using operators::WordSequence;
using random::Purpose;

EvolutionaryProgramming::EvolutionaryProgramming(EvolutionaryProgrammingSettings settings)
    : OffLine(settings.population, settings.first_genes), settings_(std::move(settings)) {
  require_within("population", settings_.population, smallest_population, largest_population);
  if (settings_.survival == Survival::tournament) {
    require_within("opponents", settings_.opponents, 1, 2.0 * settings_.population - 1);
  }
  require_ordered(settings_.steps);
}

void EvolutionaryProgramming::found(std::vector<Member> first) {
  for (Member& member : first) members_.push_back({std::move(member), settings_.steps.first});
}

std::vector<std::vector<double>> EvolutionaryProgramming::breed(const Training& training, std::uint32_t generation) {
  children_deviations_.clear();
  std::vector<std::vector<double>> next;
  for (std::uint32_t number = 0; number < settings_.population; ++number) {
    std::vector<double> genes = members_[number].member.genes;
    double standard_deviation = members_[number].standard_deviation;
    WordSequence steps(training.stream, generation, Purpose::mutation, number);
    mutate_adapted(training.problem.plan(), settings_.steps, steps, genes, standard_deviation);
    children_deviations_.push_back(standard_deviation);
    next.push_back(std::move(genes));
  }
  return next;
}

void EvolutionaryProgramming::compete(const random::Stream& stream, std::uint32_t generation) {
  const auto all = static_cast<std::uint32_t>(members_.size());
  for (std::uint32_t i = 0; i < all; ++i) {
    WordSequence words(stream, generation, Purpose::selection, i);
    members_[i].score = 0;
    for (const std::uint32_t other : operators::choose_distinct(words, settings_.opponents, all - 1)) {
      const std::uint32_t opponent = other < i ? other : other + 1;
      members_[i].score += members_[opponent].member.cost >= members_[i].member.cost;
    }
  }
}

void EvolutionaryProgramming::survive(const Training& training, std::uint32_t generation,
                                      std::vector<Member> children) {
  for (std::size_t i = 0; i < children.size(); ++i) {
    members_.push_back({std::move(children[i]), children_deviations_[i]});
  }
  // Under best_half all scores stay 0.
  if (settings_.survival == Survival::tournament) compete(training.stream, generation);
  std::ranges::stable_sort(members_, [](const Adapted& left, const Adapted& right) {
    return left.score != right.score ? left.score > right.score : left.member.cost < right.member.cost;
  });
  members_.resize(settings_.population);
}

// Scores are of one selection, which sets them all.

void EvolutionaryProgramming::save_population(const Training& training, std::uint32_t /*generation*/,
                                              saving::Writer& writer) const {
  for (const Adapted& member : members_) member_fields(writer, training.problem.plan(), member);
}

void EvolutionaryProgramming::restore_population(const Training& training, std::uint32_t /*generation*/,
                                                 saving::Reader& reader) {
  members_.resize(settings_.population);
  for (Adapted& member : members_) member_fields(reader, training.problem.plan(), member);
}

}  // namespace lamprey::science::evolution::trainers
