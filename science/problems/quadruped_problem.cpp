#include "science/problems/quadruped_problem.hpp"

#include "science/gaits/presets.hpp"
#include "science/problems/controlled_quadruped.hpp"
#include "science/problems/output_agreement.hpp"
#include "science/problems/quadruped_controllers.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace lamprey::science::problems {

namespace {

using gaits::Gait;

template <Controller C>
std::unique_ptr<evolution::Problem> controlled(C controller, const QuadrupedSettings& settings,
                                               std::unique_ptr<const evolution::Problem> wanted) {
  if constexpr (C::output_kind == actuators::OutputKind::pulses) {
    if (settings.actuator.path == actuators::ActuatorPath::unit_move) {
      return std::make_unique<ControlledQuadruped<C, DirectPath>>(
          std::move(controller), DirectPath{}, settings.time_steps, std::move(wanted), settings.machine);
    }
  }
  return std::make_unique<ControlledQuadruped<C, ActuatorPath>>(
      std::move(controller), ActuatorPath{settings.actuator, C::output_kind}, settings.time_steps, std::move(wanted),
      settings.machine);
}

/// What is expected of a robot is what the simulated one does.
std::unique_ptr<evolution::Problem> simulated_four_mother(QuadrupedSettings settings) {
  settings.machine = nullptr;
  return controlled(FourMotherController{gaits::four_mother(settings.gait)}, settings, nullptr);
}

std::unique_ptr<evolution::Problem> four_mother(const QuadrupedSettings& settings) {
  if (settings.machine == nullptr) return simulated_four_mother(settings);
  return controlled(FourMotherController{gaits::four_mother(settings.gait)}, settings, simulated_four_mother(settings));
}

/// A network that is to do what the four-mother network's preset does.
template <Controller C>
std::unique_ptr<evolution::Problem> measured_by_four_mother(C controller, const QuadrupedSettings& settings) {
  return controlled(std::move(controller), settings, simulated_four_mother(settings));
}

template <Controller C>
std::unique_ptr<evolution::Problem> frames_or_walk(C controller, const QuadrupedSettings& settings) {
  if (settings.gait == Gait::walk_frames) {
    return std::make_unique<OutputAgreement<C>>(std::move(controller), settings.time_steps);
  }
  return measured_by_four_mother(std::move(controller), settings);
}

}  // namespace

bool has_preset(QuadrupedNetwork network, Gait gait) {
  switch (network) {
    case QuadrupedNetwork::four_mother:
    case QuadrupedNetwork::timed_loop:
      return gait != Gait::walk_frames;
    case QuadrupedNetwork::one_mother:
      return true;
    case QuadrupedNetwork::recurrent_eight:
      return gait == Gait::walk || gait == Gait::walk_frames;
    case QuadrupedNetwork::split_generator:
      return gait != Gait::walk && gait != Gait::walk_frames;
    case QuadrupedNetwork::tonic:
      return gait != Gait::pronk && gait != Gait::walk_frames;
  }
  return false;
}

std::unique_ptr<evolution::Problem> make_quadruped_problem(const QuadrupedSettings& settings) {
  if (settings.time_steps < 1) {
    throw std::invalid_argument("time_steps is " + std::to_string(settings.time_steps) + "; at least 1");
  }
  switch (settings.network) {
    case QuadrupedNetwork::four_mother:
      return four_mother(settings);
    case QuadrupedNetwork::one_mother:
      return frames_or_walk(OneMotherController{gaits::one_mother(settings.gait)}, settings);
    case QuadrupedNetwork::recurrent_eight:
      return frames_or_walk(RecurrentEightController{gaits::recurrent_eight(settings.gait, settings.delay_refirings)},
                            settings);
    case QuadrupedNetwork::split_generator:
      return measured_by_four_mother(SplitGeneratorController{gaits::split_generator(settings.gait)}, settings);
    case QuadrupedNetwork::tonic:
      return measured_by_four_mother(
          TonicController{gaits::tonic(settings.gait), settings.tonic_genes == TonicGenes::tonic_and_weights},
          settings);
    case QuadrupedNetwork::timed_loop:
      return measured_by_four_mother(TimedLoopController{gaits::timed_loop(settings.gait)}, settings);
  }
  throw std::invalid_argument("no such network");
}

}  // namespace lamprey::science::problems
