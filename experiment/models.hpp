#pragma once

#include "experiment/parameters.hpp"
#include "science/evolution/problem.hpp"
#include "science/evolution/trainer.hpp"
#include "science/robots/machine.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace lamprey::experiment {

/// How far an outcome can be had again: the same bits anywhere; the same bits from the same build on the same kind of
/// machine (optimisers from outside); never, since a robot did it.
enum class Repeatability : std::uint8_t { bitwise, same_build, physical };

/// "bitwise", "same_build", "physical".
std::string_view to_text(Repeatability repeatability);

/// A network, with the robot that it moves: what a trainer tunes.
struct NetworkModel {
  std::string_view name;    ///< the value of `network`
  std::string_view source;  ///< equation, figure or section
  Repeatability repeatability = Repeatability::bitwise;
  std::unique_ptr<science::evolution::Problem> (*make)(const Parameters& parameters, science::robots::Machine* machine);
};

/// A way to tune.
struct TrainerModel {
  std::string_view name;    ///< the value of `trainer`
  std::string_view source;  ///< section, or library
  Repeatability repeatability = Repeatability::bitwise;
  std::unique_ptr<science::evolution::Trainer> (*make)(const Parameters& parameters,
                                                       const science::evolution::Problem& problem,
                                                       const science::random::Stream& stream);
};

/// All there are, the default first. Adding one is a row here, its file and its test.
std::span<const NetworkModel> network_models();
std::span<const TrainerModel> trainer_models();

/// What a job of these parameters tunes and how; the trainer refers to the problem. Throws std::invalid_argument,
/// naming parameter and value, for a choice that this program has no model of. A job on a robot (`robot: bridge`) is
/// evaluated on `machine`, which outlives the problem; any other in simulation. Without a machine a robot's problem is
/// simulated, too: for what doesn't evaluate, such as its plan of genes.
std::unique_ptr<science::evolution::Problem> make_problem(const Parameters& parameters,
                                                          science::robots::Machine* machine = nullptr);
std::unique_ptr<science::evolution::Trainer> make_trainer(const Parameters& parameters,
                                                          const science::evolution::Problem& problem,
                                                          const science::random::Stream& stream);

/// Whether jobs of these parameters are evaluated on a robot.
bool on_a_robot(const Parameters& parameters);

/// The weakest of the robot's, the network's and the trainer's.
Repeatability repeatability(const Parameters& parameters);

}  // namespace lamprey::experiment
