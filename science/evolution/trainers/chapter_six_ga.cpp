#include "science/evolution/trainers/chapter_six_ga.hpp"

#include "science/evolution/operators/crossover.hpp"
#include "science/evolution/operators/selection.hpp"
#include "science/evolution/operators/uniform_mutation.hpp"

#include <utility>

namespace lamprey::science::evolution::trainers {

namespace {

using operators::WordSequence;
using random::Purpose;
using Genes = std::vector<double>;

constexpr std::uint32_t half = ChapterSixGa::population / 2;

std::vector<Genes> reproduced(const std::vector<Member>& members, const random::Stream& stream,
                              std::uint32_t generation) {
  std::vector<Genes> next;
  for (const std::uint32_t position : operators::ranking(costs(members))) next.push_back(members[position].genes);
  WordSequence words(stream, generation, Purpose::selection, 0);
  for (std::uint32_t place = half; place < ChapterSixGa::population; ++place) {
    next[place] = next[random::bounded(words.word(place), half)];
  }
  return next;
}

}  // namespace

// The founder is one only: the whole first population is tried as the first generation.
ChapterSixGa::ChapterSixGa(ChapterSixGaSettings settings)
    : OffLine(1, std::move(settings.first_genes)), mutation_rate_(settings.mutation_rate) {
  require_within("mutation_rate", mutation_rate_, 0, 100);
}

void ChapterSixGa::found(std::vector<Member> /*first*/) {}

std::vector<Genes> ChapterSixGa::breed(const Training& training, std::uint32_t generation) {
  std::vector<Genes> next;
  if (members_.empty()) {
    for (std::uint32_t member = 0; member < population; ++member) next.push_back(first_member(training, member));
    return next;
  }
  const GenePlan& plan = training.problem.plan();
  const random::Stream& stream = training.stream;
  next = reproduced(members_, stream, generation);
  for (std::uint32_t place = half; place < population; place += 2) {
    WordSequence words(stream, generation, Purpose::crossover, (place - half) / 2);
    auto children = operators::cross(operators::Crossover::one_point, 0, plan, next[place], next[place + 1], words);
    next[place] = std::move(children.first);
    next[place + 1] = std::move(children.second);
  }
  const std::uint32_t mutated = operators::mutated_count(plan.genes.size(), mutation_rate_);
  for (std::uint32_t place = half; place < population; ++place) {
    WordSequence choice(stream, generation, Purpose::mutation_choice, place);
    WordSequence values(stream, generation, Purpose::mutation, place);
    operators::redraw_some(plan, mutated, choice, values, next[place]);
  }
  return next;
}

void ChapterSixGa::survive(const Training& /*training*/, std::uint32_t /*generation*/, std::vector<Member> members) {
  members_ = std::move(members);
}

void ChapterSixGa::save_population(const Training& training, std::uint32_t /*generation*/,
                                   saving::Writer& writer) const {
  for (const Member& member : members_) fields(writer, training.problem.plan(), member);
}

void ChapterSixGa::restore_population(const Training& training, std::uint32_t generation, saving::Reader& reader) {
  members_.resize(generation > 1 ? population : 0);
  for (Member& member : members_) fields(reader, training.problem.plan(), member);
}

}  // namespace lamprey::science::evolution::trainers
