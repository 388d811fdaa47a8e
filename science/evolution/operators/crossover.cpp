#include "science/evolution/operators/crossover.hpp"

#include "science/evolution/operators/choice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lamprey::science::evolution::operators {

namespace {

using Genes = std::span<const double>;

void exchange(Children& children, std::size_t begin, std::size_t end) {
  for (std::size_t gene = begin; gene < end; ++gene) std::swap(children.first[gene], children.second[gene]);
}

/// A lone gene has nothing to be exchanged against.
void one_point(Children& children, WordSequence& words) {
  const std::size_t genes = children.first.size();
  if (genes < 2) return;
  exchange(children, 1 + random::bounded(words.word(0), static_cast<std::uint32_t>(genes) - 1), genes);
}

void two_point(Children& children, WordSequence& words) {
  const auto genes = static_cast<std::uint32_t>(children.first.size());
  if (genes < 3) return one_point(children, words);
  const auto points = choose_distinct(words, 2, genes - 1);
  exchange(children, 1 + std::min(points[0], points[1]), 1 + std::max(points[0], points[1]));
}

void blend(Children& children, Genes mother, Genes father, WordSequence& words) {
  const double beta = words.unit(0);
  for (std::size_t gene = 0; gene < mother.size(); ++gene) {
    children.first[gene] = beta * mother[gene] + (1 - beta) * father[gene];
    children.second[gene] = (1 - beta) * mother[gene] + beta * father[gene];
  }
}

void michalewicz(Children& children, Genes mother, Genes father, WordSequence& words) {
  const double beta = words.unit(0);
  for (std::size_t gene = 0; gene < mother.size(); ++gene) {
    const double difference = mother[gene] - father[gene];
    children.first[gene] = beta * difference + mother[gene];
    children.second[gene] = (1 - beta) * difference + mother[gene];
  }
}

void blx_alpha(Children& children, double alpha, Genes mother, Genes father, WordSequence& words) {
  for (std::uint32_t gene = 0; gene < mother.size(); ++gene) {
    const double distance = std::fabs(mother[gene] - father[gene]);
    const double lowest = std::min(mother[gene], father[gene]) - alpha * distance;
    const double width = (1 + 2 * alpha) * distance;
    children.first[gene] = lowest + width * words.unit(2 * gene);
    children.second[gene] = lowest + width * words.unit(2 * gene + 1);
  }
}

void hold(const GenePlan& plan, std::vector<double>& genes) {
  for (std::size_t gene = 0; gene < genes.size(); ++gene) genes[gene] = held(plan.genes[gene], genes[gene]);
}

}  // namespace

Children cross(Crossover crossover, double alpha, const GenePlan& plan, Genes mother, Genes father,
               WordSequence& words) {
  Children children{.first = {mother.begin(), mother.end()}, .second = {father.begin(), father.end()}};
  switch (crossover) {
    case Crossover::one_point:
      one_point(children, words);
      break;
    case Crossover::two_point:
      two_point(children, words);
      break;
    case Crossover::blend:
      blend(children, mother, father, words);
      break;
    case Crossover::michalewicz:
      michalewicz(children, mother, father, words);
      break;
    case Crossover::blx_alpha:
      blx_alpha(children, alpha, mother, father, words);
      break;
  }
  hold(plan, children.first);
  hold(plan, children.second);
  return children;
}

std::vector<double> recombine(Genes mother, Genes father, WordSequence& words) {
  std::vector<double> child(mother.begin(), mother.end());
  for (std::uint32_t gene = 0; gene < child.size(); ++gene) {
    if (random::bounded(words.word(gene), 2) == 1) child[gene] = father[gene];
  }
  return child;
}

}  // namespace lamprey::science::evolution::operators
