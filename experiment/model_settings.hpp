#pragma once

#include "experiment/parameters.hpp"
#include "experiment/yardsticks/pagmo_trainer.hpp"
#include "science/evolution/disturbance.hpp"
#include "science/evolution/rtea.hpp"
#include "science/evolution/trainers/chapter_six_ga.hpp"
#include "science/evolution/trainers/evolution_strategy.hpp"
#include "science/evolution/trainers/evolutionary_programming.hpp"
#include "science/evolution/trainers/genetic_algorithm.hpp"
#include "science/evolution/trainers/ii_rtea.hpp"
#include "science/evolution/trainers/simulated_annealing.hpp"
#include "science/problems/biped_problem.hpp"
#include "science/problems/quadruped_problem.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace lamprey::experiment {

// Parameters in the science's own types: the registry's names end here.

/// What is thrown for a choice that nothing here knows.
std::invalid_argument no_model_of(std::string_view parameter, std::string_view value);

template <typename Meaning>
using Choice = std::pair<std::string_view, Meaning>;

/// What the parameter's choice means. Throws std::invalid_argument, naming parameter and value, for one not listed.
template <typename Meaning, std::size_t Count>
Meaning choose(const Parameters& parameters, std::string_view name, const std::array<Choice<Meaning>, Count>& choices) {
  const std::string& value = parameters.choice(name);
  const auto known = std::ranges::find(choices, value, &Choice<Meaning>::first);
  if (known == choices.end()) {
    throw no_model_of(name, value);
  }
  return known->second;
}

inline std::uint32_t count_of(const Parameters& parameters, std::string_view name) {
  return static_cast<std::uint32_t>(parameters.integer(name));
}

science::evolution::RteaSettings rtea_settings(const Parameters& parameters);
science::evolution::Disturbance disturbance_settings(const Parameters& parameters);
science::evolution::MutationTechnique mutation_setting(const Parameters& parameters);

science::problems::QuadrupedSettings quadruped_settings(const Parameters& parameters,
                                                        science::problems::QuadrupedNetwork network);
science::problems::BipedSettings biped_settings(const Parameters& parameters, science::problems::BipedNetwork network);

// Without makers of first genes.
science::evolution::trainers::IiRteaSettings ii_rtea_settings(const Parameters& parameters);
science::evolution::trainers::ChapterSixGaSettings chapter_six_ga_settings(const Parameters& parameters);
science::evolution::trainers::GeneticAlgorithmSettings genetic_algorithm_settings(const Parameters& parameters);
science::evolution::trainers::SimulatedAnnealingSettings simulated_annealing_settings(const Parameters& parameters);
science::evolution::trainers::EvolutionStrategySettings evolution_strategy_settings(const Parameters& parameters);
science::evolution::trainers::EvolutionaryProgrammingSettings evolutionary_programming_settings(
    const Parameters& parameters);
yardsticks::PagmoSgaSettings pagmo_sga_settings(const Parameters& parameters);
yardsticks::PagmoSimulatedAnnealingSettings pagmo_simulated_annealing_settings(const Parameters& parameters);
yardsticks::PagmoCmaesSettings pagmo_cmaes_settings(const Parameters& parameters);

}  // namespace lamprey::experiment
