#include "science/evolution/trainers/off_line.hpp"

#include "science/evolution/operators/uniform_mutation.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>

namespace lamprey::science::evolution::trainers {

std::vector<double> first_genes(const FirstGenes& maker, const Training& training, std::uint32_t member) {
  const GenePlan& plan = training.problem.plan();
  if (!maker) return operators::draw_genes(training.stream, member, plan);
  std::vector<double> genes = maker(member);
  if (genes.size() != plan.genes.size()) {
    throw std::invalid_argument("member " + std::to_string(member) + " begins with " + std::to_string(genes.size()) +
                                " genes, but the problem has " + std::to_string(plan.genes.size()));
  }
  return genes;
}

void require_within(std::string_view name, double value, double minimum, double maximum) {
  if (value >= minimum && value <= maximum) return;
  std::ostringstream message;
  message << name << " is " << value << ", but must be " << minimum << ".." << maximum;
  throw std::invalid_argument(message.str());
}

std::vector<double> costs(std::span<const Member> members) {
  std::vector<double> result;
  result.reserve(members.size());
  for (const Member& member : members) result.push_back(member.cost);
  return result;
}

fitness::Fitness BestSoFar::first(const Training& training, std::vector<double> genes) {
  Body standing;
  const fitness::Fitness fitness = training.problem.evaluate(genes, training.environment, standing);
  best_ = {.genes = std::move(genes), .cost = cost(training, fitness)};
  return fitness;
}

double BestSoFar::attempt(const Training& training, std::span<const double> genes, std::vector<CycleReport>& reports) {
  Body standing;
  const fitness::Fitness fitness = training.problem.evaluate(genes, training.environment, standing);
  const double now = cost(training, fitness);
  const bool better = now < best_.cost;
  if (better) best_ = {.genes = {genes.begin(), genes.end()}, .cost = now};
  reports.push_back({.fitness = fitness, .accepted = better, .success = better});
  return now;
}

fitness::Fitness OffLine::begin(const Training& training) {
  const fitness::Fitness fitness = best_.first(training, first_member(training, 0));
  first_ = best_.best();
  if (population_ == 1) conclude(training);
  return fitness;
}

void OffLine::prepare(const Training& training) {
  if (candidates_.empty() && generation_ > 0) candidates_ = breed(training, generation_);
  if (candidates_.empty()) {
    for (std::uint32_t member = 1; member < population_; ++member) {
      candidates_.push_back(first_member(training, member));
    }
  }
}

void OffLine::advance(const Training& training, std::uint32_t budget, std::vector<CycleReport>& reports) {
  prepare(training);
  const std::size_t end = std::min(candidates_.size(), tried_.size() + budget);
  while (tried_.size() < end) tried_.push_back(best_.attempt(training, candidates_[tried_.size()], reports));
  if (tried_.size() == candidates_.size()) conclude(training);
}

// Of a generation that was cut short only the costs are kept: its candidates are bred again.

void OffLine::save(const Training& training, saving::Writer& writer) const {
  const GenePlan& plan = training.problem.plan();
  fields(writer, plan, best_.best());
  writer.whole("generation", generation_, 0, generation_);
  if (generation_ == 0) {
    fields(writer, plan, first_);
  } else {
    save_population(training, generation_, writer);
  }
  saving::counted_reals(writer, "costs of the generation", tried_, static_cast<std::uint32_t>(tried_.size()),
                        -largest_cost, largest_cost);
}

void OffLine::restore(const Training& training, std::uint32_t cycles, saving::Reader& reader) {
  const GenePlan& plan = training.problem.plan();
  Member best;
  fields(reader, plan, best);
  best_.restore(std::move(best));
  // A population of one is founded at once.
  reader.whole("generation", generation_, population_ == 1 ? 1 : 0, cycles + 1);
  if (generation_ == 0) {
    fields(reader, plan, first_);
  } else {
    restore_population(training, generation_, reader);
  }
  saving::counted_reals(reader, "costs of the generation", tried_, cycles, -largest_cost, largest_cost);
  if (tried_.empty()) return;
  prepare(training);
  if (tried_.size() >= candidates_.size()) {
    throw saving::Invalid("a generation of " + std::to_string(candidates_.size()) + " under way has " +
                          std::to_string(tried_.size()) + " costs");
  }
}

void OffLine::conclude(const Training& training) {
  std::vector<Member> members;
  if (generation_ == 0) members.push_back(std::move(first_));
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    members.push_back({.genes = std::move(candidates_[i]), .cost = tried_[i]});
  }
  candidates_.clear();
  tried_.clear();
  if (generation_ == 0) {
    found(std::move(members));
  } else {
    survive(training, generation_, std::move(members));
  }
  ++generation_;
}

}  // namespace lamprey::science::evolution::trainers
