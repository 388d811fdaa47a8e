#include "experiment/models.hpp"

#include "experiment/model_settings.hpp"
#include "experiment/yardsticks/pagmo_trainer.hpp"
#include "science/evolution/gait_change.hpp"
#include "science/evolution/trainers/chapter_six_ga.hpp"
#include "science/evolution/trainers/evolution_strategy.hpp"
#include "science/evolution/trainers/evolutionary_programming.hpp"
#include "science/evolution/trainers/genetic_algorithm.hpp"
#include "science/evolution/trainers/hybrid.hpp"
#include "science/evolution/trainers/ii_rtea.hpp"
#include "science/evolution/trainers/simulated_annealing.hpp"
#include "science/problems/biped_problem.hpp"
#include "science/problems/quadruped_problem.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace lamprey::experiment {

namespace {

using namespace science;
using evolution::Problem;
using evolution::Trainer;
using problems::BipedNetwork;
using problems::QuadrupedNetwork;

template <QuadrupedNetwork network>
std::unique_ptr<Problem> quadruped_with(const Parameters& parameters, robots::Machine* machine) {
  auto settings = quadruped_settings(parameters, network);
  settings.machine = machine;
  return problems::make_quadruped_problem(settings);
}

template <BipedNetwork network>
std::unique_ptr<Problem> biped_with(const Parameters& parameters, robots::Machine* /*machine*/) {
  return problems::make_biped_problem(biped_settings(parameters, network));
}

constexpr std::array networks{
    NetworkModel{"four_mother", "7.4.4, eq. 7.11, fig. 7.23", Repeatability::bitwise,
                 quadruped_with<QuadrupedNetwork::four_mother>},
    NetworkModel{"one_mother", "7.4.3, eq. 7.11, fig. 7.21", Repeatability::bitwise,
                 quadruped_with<QuadrupedNetwork::one_mother>},
    NetworkModel{"recurrent_eight", "7.4.2, eq. 7.10, figs 7.14 and 7.15", Repeatability::bitwise,
                 quadruped_with<QuadrupedNetwork::recurrent_eight>},
    NetworkModel{"split_generator", "2.6.1, fig. 2.7", Repeatability::bitwise,
                 quadruped_with<QuadrupedNetwork::split_generator>},
    NetworkModel{"tonic", "9.3, eq. 9.1, figs 9.1 to 9.3", Repeatability::bitwise,
                 quadruped_with<QuadrupedNetwork::tonic>},
    NetworkModel{"timed_loop", "9.2", Repeatability::bitwise, quadruped_with<QuadrupedNetwork::timed_loop>},
    NetworkModel{"recurrent_pair", "6.2.2.1, fig. 6.11", Repeatability::bitwise,
                 biped_with<BipedNetwork::recurrent_pair>},
    NetworkModel{"feed_forward_pair", "6.2.2.3, fig. 6.18", Repeatability::bitwise,
                 biped_with<BipedNetwork::feed_forward_pair>},
};

/// Makes the first genes of each member: the preset, disturbed, or drawn within bounds.
evolution::trainers::FirstGenes first_genes(const Parameters& parameters, const Problem& problem,
                                            const random::Stream& stream) {
  return [disturbance = disturbance_settings(parameters), &problem, stream](std::uint32_t member) {
    return evolution::initial_genes(problem, disturbance, stream, member);
  };
}

std::unique_ptr<Trainer> make_rtea(const Parameters& parameters, const Problem& problem, const random::Stream& stream) {
  // 9.4: the tonic has no fitness to evolve towards; its mutations are kept, and what counts is the gaits they reach.
  if (parameters.choice("network") == "tonic") {
    return std::make_unique<evolution::GaitChange>(mutation_setting(parameters));
  }
  return std::make_unique<evolution::Rtea>(rtea_settings(parameters), first_genes(parameters, problem, stream)(0));
}

/// A trainer whose settings are made of parameters and a maker of first genes.
template <typename Made, auto settings>
std::unique_ptr<Trainer> make_with(const Parameters& parameters, const Problem& problem, const random::Stream& stream) {
  auto made = settings(parameters);
  made.first_genes = first_genes(parameters, problem, stream);
  return std::make_unique<Made>(std::move(made));
}

std::unique_ptr<Trainer> make_hybrid(const Parameters& parameters, const Problem& problem,
                                     const random::Stream& stream) {
  namespace trainers = evolution::trainers;
  const auto share =
      static_cast<std::uint32_t>(parameters.integer("cycles") * parameters.integer("hybrid_share") / 100);
  return std::make_unique<trainers::Hybrid>(
      make_with<trainers::GeneticAlgorithm, genetic_algorithm_settings>(parameters, problem, stream),
      [settings = rtea_settings(parameters)](std::vector<double> genes) -> std::unique_ptr<Trainer> {
        return std::make_unique<evolution::Rtea>(settings, std::move(genes));
      },
      share);
}

namespace kinds = evolution::trainers;

constexpr std::array trainers{
    TrainerModel{"rtea", "4.2, fig. 4.1; 9.4", Repeatability::bitwise, make_rtea},
    TrainerModel{"ii_rtea", "6.2.2.7, fig. 6.29", Repeatability::bitwise, make_with<kinds::IiRtea, ii_rtea_settings>},
    TrainerModel{"chapter_6_ga", "6.2.2.4, fig. 6.22", Repeatability::bitwise,
                 make_with<kinds::ChapterSixGa, chapter_six_ga_settings>},
    TrainerModel{"genetic_algorithm", "3.3, fig. 3.5", Repeatability::bitwise,
                 make_with<kinds::GeneticAlgorithm, genetic_algorithm_settings>},
    TrainerModel{"simulated_annealing", "3.4", Repeatability::bitwise,
                 make_with<kinds::SimulatedAnnealing, simulated_annealing_settings>},
    TrainerModel{"evolution_strategy", "3.6", Repeatability::bitwise,
                 make_with<kinds::EvolutionStrategy, evolution_strategy_settings>},
    TrainerModel{"evolutionary_programming", "3.7", Repeatability::bitwise,
                 make_with<kinds::EvolutionaryProgramming, evolutionary_programming_settings>},
    TrainerModel{"hybrid", "3.8", Repeatability::bitwise, make_hybrid},
    TrainerModel{"pagmo_sga", "pagmo2, sga", Repeatability::same_build,
                 make_with<yardsticks::PagmoTrainer, pagmo_sga_settings>},
    TrainerModel{"pagmo_simulated_annealing", "pagmo2, simulated_annealing", Repeatability::same_build,
                 make_with<yardsticks::PagmoTrainer, pagmo_simulated_annealing_settings>},
    TrainerModel{"pagmo_cmaes", "pagmo2, cmaes", Repeatability::same_build,
                 make_with<yardsticks::PagmoTrainer, pagmo_cmaes_settings>},
};

template <typename Model>
const Model& named(std::span<const Model> models, const Parameters& parameters, std::string_view parameter) {
  const std::string& name = parameters.choice(parameter);
  const auto model = std::ranges::find(models, name, &Model::name);
  if (model == models.end()) throw no_model_of(parameter, name);
  return *model;
}

const NetworkModel& network_of(const Parameters& parameters) {
  return named(network_models(), parameters, "network");
}
const TrainerModel& trainer_of(const Parameters& parameters) {
  return named(trainer_models(), parameters, "trainer");
}

}  // namespace

std::string_view to_text(Repeatability repeatability) {
  constexpr std::array<std::string_view, 3> texts{"bitwise", "same_build", "physical"};
  return texts[static_cast<std::size_t>(repeatability)];
}

std::span<const NetworkModel> network_models() {
  return networks;
}
std::span<const TrainerModel> trainer_models() {
  return trainers;
}

std::unique_ptr<Problem> make_problem(const Parameters& parameters, robots::Machine* machine) {
  return network_of(parameters).make(parameters, on_a_robot(parameters) ? machine : nullptr);
}

std::unique_ptr<Trainer> make_trainer(const Parameters& parameters, const Problem& problem,
                                      const random::Stream& stream) {
  return trainer_of(parameters).make(parameters, problem, stream);
}

bool on_a_robot(const Parameters& parameters) {
  return parameters.choice("robot") == "bridge";
}

Repeatability repeatability(const Parameters& parameters) {
  if (on_a_robot(parameters)) return Repeatability::physical;
  return std::max(network_of(parameters).repeatability, trainer_of(parameters).repeatability);
}

}  // namespace lamprey::experiment
