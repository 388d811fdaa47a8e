#include "science/evolution/trainers/genetic_algorithm.hpp"

#include "science/evolution/operators/uniform_mutation.hpp"

#include <algorithm>
#include <utility>

namespace lamprey::science::evolution::trainers {

using operators::WordSequence;
using random::Purpose;

GeneticAlgorithm::GeneticAlgorithm(GeneticAlgorithmSettings settings)
    : OffLine(settings.population, settings.first_genes), settings_(std::move(settings)) {
  require_within("population", settings_.population, smallest_population, largest_population);
  if (settings_.selection == operators::Selection::tournament) {
    require_within("tournament_size", settings_.tournament_size, 1, settings_.population);
  }
  require_within("blend_alpha", settings_.blend_alpha, 0, 2);
  require_within("mutation_rate", settings_.mutation_rate, 0, 100);
}

void GeneticAlgorithm::found(std::vector<Member> first) {
  members_ = std::move(first);
  by_rank_ = operators::ranking(costs(members_));
}

operators::Children GeneticAlgorithm::children(const Training& training, std::uint32_t generation,
                                               std::uint32_t pair) const {
  const auto select = [&](std::uint32_t parent) {
    WordSequence words(training.stream, generation, Purpose::selection, 2 * pair + parent);
    return operators::select_rank(settings_.selection, settings_.tournament_size, settings_.population, words);
  };
  const auto [mother, father] = std::minmax({select(0), select(1)});
  WordSequence words(training.stream, generation, Purpose::crossover, pair);
  return operators::cross(settings_.crossover, settings_.blend_alpha, training.problem.plan(),
                          members_[by_rank_[mother]].genes, members_[by_rank_[father]].genes, words);
}

std::vector<std::vector<double>> GeneticAlgorithm::breed(const Training& training, std::uint32_t generation) {
  const std::uint32_t born = settings_.population - 1;
  std::vector<std::vector<double>> next;
  for (std::uint32_t pair = 0; next.size() < born; ++pair) {
    operators::Children both = children(training, generation, pair);
    next.push_back(std::move(both.first));
    if (next.size() < born) next.push_back(std::move(both.second));
  }
  for (std::uint32_t child = 0; child < born; ++child) {
    WordSequence words(training.stream, generation, Purpose::mutation, child);
    operators::redraw_each(training.problem.plan(), settings_.mutation_rate, words, next[child]);
  }
  return next;
}

void GeneticAlgorithm::survive(const Training& /*training*/, std::uint32_t /*generation*/,
                               std::vector<Member> children) {
  children.insert(children.begin(), std::move(members_[by_rank_.front()]));
  found(std::move(children));
}

void GeneticAlgorithm::save_population(const Training& training, std::uint32_t /*generation*/,
                                       saving::Writer& writer) const {
  for (const Member& member : members_) fields(writer, training.problem.plan(), member);
}

void GeneticAlgorithm::restore_population(const Training& training, std::uint32_t /*generation*/,
                                          saving::Reader& reader) {
  std::vector<Member> members(settings_.population);
  for (Member& member : members) fields(reader, training.problem.plan(), member);
  found(std::move(members));
}

}  // namespace lamprey::science::evolution::trainers
