#include "experiment/yardsticks/pagmo_trainer.hpp"

// Eigen's matrices go to and fro between this source and libpagmo, which was built without sanitizers and frees them
// with free(). Under the address sanitizer Eigen's headers would not take them from malloc(), though that aligns them.
#ifdef __SANITIZE_ADDRESS__
#define EIGEN_MALLOC_ALREADY_ALIGNED 1
#endif

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/algorithms/simulated_annealing.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <pagmo/types.hpp>
#include <stdexcept>
#include <utility>

namespace lamprey::experiment::yardsticks {

namespace {

using namespace science::evolution;
using trainers::BestSoFar;
using trainers::FirstGenes;
using trainers::Member;

/// Thrown through pagmo2 when it asks for more than the budget allows.
struct BudgetSpent {};

/// One run of an optimiser: first the costs that are known, then as many evaluations as are left.
struct Run {
  const Training& training;
  BestSoFar& best;
  std::vector<double>& known;  ///< costs of the candidates of this run, in order; grows
  std::vector<CycleReport>& reports;
  std::uint32_t left = 0;
  std::size_t asked = 0;

  double cost_of(const std::vector<double>& candidate) {
    if (asked == known.size()) known.push_back(evaluated(candidate));
    return known[asked++];
  }

 private:
  double evaluated(std::vector<double> genes) {
    if (left == 0) throw BudgetSpent{};
    const GenePlan& plan = training.problem.plan();
    for (std::size_t gene = 0; gene < genes.size(); ++gene) {
      if (std::isnan(genes[gene])) throw std::runtime_error("pagmo2 asks for a gene that is no number");
      genes[gene] = held(plan.genes[gene], genes[gene]);
    }
    --left;
    return best.attempt(training, genes, reports);
  }
};

/// What pagmo2 calls a problem. It copies it at will, so it only points to the run.
class Minimised {
 public:
  Minimised() = default;  // pagmo2 demands it
  explicit Minimised(Run& run) : run_(&run) {}

  pagmo::vector_double fitness(const pagmo::vector_double& candidate) const { return {run_->cost_of(candidate)}; }

  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    std::pair<pagmo::vector_double, pagmo::vector_double> bounds;
    for (const Gene& gene : run_->training.problem.plan().genes) {
      bounds.first.push_back(gene.minimum);
      bounds.second.push_back(gene.maximum);
    }
    return bounds;
  }

 private:
  Run* run_ = nullptr;
};

pagmo::population to_pagmo(const std::vector<Member>& members, Run& run) {
  pagmo::population population(pagmo::problem(Minimised(run)), 0U, 0U);
  for (const Member& member : members) population.push_back(member.genes, {member.cost});
  return population;
}

std::vector<Member> from_pagmo(const pagmo::population& population) {
  std::vector<Member> members;
  for (std::size_t i = 0; i < population.size(); ++i) {
    members.push_back({.genes = population.get_x()[i], .cost = population.get_f()[i][0]});
  }
  return members;
}

using MakeAlgorithm = std::function<pagmo::algorithm(std::size_t genes, unsigned seed)>;

pagmo::algorithm make_sga(std::size_t /*genes*/, unsigned seed) {
  return pagmo::algorithm(pagmo::sga(1U, 0.9, 1.0, 0.02, 1.0, 2U, "exponential", "polynomial", "tournament", seed));
}

/// Tolerances of 0: the budget ends it, nothing else. -1 lets pagmo2 choose by the number of genes.
pagmo::algorithm make_cmaes(std::size_t /*genes*/, unsigned seed) {
  return pagmo::algorithm(pagmo::cmaes(1U, -1, -1, -1, -1, 0.5, 0, 0, true, true, seed));
}

/// Running a schedule again on its known costs takes time; this bounds it.
constexpr std::size_t longest_schedule = 10'000;
constexpr std::size_t temperature_levels = 10;

pagmo::algorithm make_annealing(std::size_t genes, unsigned seed, std::size_t planned) {
  const std::size_t rounds = std::max<std::size_t>(1, std::min(planned, longest_schedule) / genes);
  const std::size_t levels = std::min(temperature_levels, rounds);
  return pagmo::algorithm(pagmo::simulated_annealing(10.0, 0.1, static_cast<unsigned>(levels), 1U,
                                                     static_cast<unsigned>(rounds / levels), 1.0, seed));
}

}  // namespace

struct PagmoTrainer::State {
  std::uint32_t population = 1;
  FirstGenes maker;
  MakeAlgorithm make;
  BestSoFar best;
  std::vector<Member> members;                ///< at the beginning of the run under way
  std::optional<pagmo::algorithm> algorithm;  ///< likewise; none before the first run
  std::vector<double> known;                  ///< costs of that run so far

  void try_founders(const Training& training, std::uint32_t budget, std::vector<CycleReport>& reports) {
    for (; budget > 0 && members.size() < population; --budget) {
      Member member{.genes = trainers::first_genes(maker, training, static_cast<std::uint32_t>(members.size()))};
      member.cost = best.attempt(training, member.genes, reports);
      members.push_back(std::move(member));
    }
  }

  /// One run to its end or to the end of the budget.
  void run(const Training& training, std::uint32_t budget, std::vector<CycleReport>& reports) {
    if (!algorithm) {
      const auto words = training.stream.block(0, science::random::Purpose::outside, 0);
      algorithm = make(training.problem.plan().genes.size(), words[0]);
    }
    Run of_budget{.training = training, .best = best, .known = known, .reports = reports, .left = budget};
    pagmo::algorithm running = *algorithm;
    try {
      members = from_pagmo(running.evolve(to_pagmo(members, of_budget)));
      algorithm = std::move(running);
      known.clear();
    } catch (const BudgetSpent&) {
      // The next run begins where this one did, and knows what this one came to know.
    }
  }
};

PagmoTrainer::PagmoTrainer(PagmoSgaSettings settings) : state_(std::make_unique<State>()) {
  trainers::require_within("population", settings.population, trainers::smallest_population,
                           trainers::largest_population);
  state_->population = settings.population;
  state_->maker = std::move(settings.first_genes);
  state_->make = make_sga;
}

PagmoTrainer::PagmoTrainer(PagmoSimulatedAnnealingSettings settings) : state_(std::make_unique<State>()) {
  trainers::require_within("planned_evaluations", settings.planned_evaluations, 1,
                           std::numeric_limits<std::uint32_t>::max());
  state_->maker = std::move(settings.first_genes);
  state_->make = [planned = settings.planned_evaluations](std::size_t genes, unsigned seed) {
    return make_annealing(genes, seed, planned);
  };
}

PagmoTrainer::PagmoTrainer(PagmoCmaesSettings settings) : state_(std::make_unique<State>()) {
  constexpr double smallest = 5;  // pagmo2's own
  trainers::require_within("population", settings.population, smallest, trainers::largest_population);
  state_->population = settings.population;
  state_->maker = std::move(settings.first_genes);
  state_->make = make_cmaes;
}

PagmoTrainer::PagmoTrainer(const PagmoTrainer& other)
    : Trainer(other), state_(std::make_unique<State>(*other.state_)) {}

PagmoTrainer::~PagmoTrainer() = default;

science::fitness::Fitness PagmoTrainer::begin(const Training& training) {
  const auto fitness = state_->best.first(training, trainers::first_genes(state_->maker, training, 0));
  state_->members.push_back(state_->best.best());
  return fitness;
}

void PagmoTrainer::advance(const Training& training, std::uint32_t budget, std::vector<CycleReport>& reports) {
  if (state_->members.size() < state_->population) return state_->try_founders(training, budget, reports);
  const std::size_t before = reports.size();
  while (reports.size() == before) state_->run(training, budget, reports);
}

std::span<const double> PagmoTrainer::genes() const {
  return state_->best.best().genes;
}

}  // namespace lamprey::experiment::yardsticks
