#pragma once

#include "science/actuators/actuator.hpp"
#include "science/evolution/gene_plan.hpp"
#include "science/networks/four_mother.hpp"
#include "science/networks/one_mother.hpp"
#include "science/networks/recurrent_eight.hpp"
#include "science/networks/split_generator.hpp"
#include "science/networks/timed_loop.hpp"
#include "science/networks/tonic.hpp"

#include <concepts>
#include <span>
#include <type_traits>
#include <vector>

namespace lamprey::science::problems {

/// A network as a problem needs it: its preset with what is not tuned, which genes it has, and how genes become the
/// parameters that its `step` runs on. `step` gives an output per child, all of one kind.
template <class C>
concept Controller = std::is_trivially_copyable_v<typename C::State> && std::default_initializable<typename C::State> &&
    requires(const C& controller, std::span<const double> genes, const typename C::Parameters& now,
             typename C::State& state) {
  { C::output_kind } -> std::convertible_to<actuators::OutputKind>;
  { controller.plan() } -> std::same_as<evolution::GenePlan>;
  { controller.preset_genes() } -> std::same_as<std::vector<double>>;
  { controller.parameters(genes) } -> std::same_as<typename C::Parameters>;
  { step(now, state) } -> std::same_as<typename C::Outputs>;
};

struct FourMotherController {
  using Parameters = networks::FourMotherSteps;
  using State = networks::FourMotherState;
  using Outputs = networks::ChildOutputs;
  static constexpr auto output_kind = actuators::OutputKind::pulses;

  networks::FourMotherNetwork preset;

  evolution::GenePlan plan() const;
  std::vector<double> preset_genes() const;
  Parameters parameters(std::span<const double> genes) const;
};

struct OneMotherController {
  using Parameters = networks::OneMotherSteps;
  using State = networks::OneMotherState;
  using Outputs = networks::ChildOutputs;
  static constexpr auto output_kind = actuators::OutputKind::pulses;

  networks::OneMotherNetwork preset;

  evolution::GenePlan plan() const;
  std::vector<double> preset_genes() const;
  Parameters parameters(std::span<const double> genes) const;
};

struct RecurrentEightController {
  using Parameters = networks::RecurrentEightSteps;
  using State = networks::RecurrentEightState;
  using Outputs = networks::ChildOutputs;
  static constexpr auto output_kind = actuators::OutputKind::pulses;

  networks::RecurrentEightNetwork preset;

  evolution::GenePlan plan() const;
  std::vector<double> preset_genes() const;
  Parameters parameters(std::span<const double> genes) const;
};

struct TimedLoopController {
  using Parameters = networks::TimedLoopSteps;
  using State = networks::TimedLoopState;
  using Outputs = networks::ChildOutputs;
  static constexpr auto output_kind = actuators::OutputKind::pulses;

  networks::TimedLoop preset;

  evolution::GenePlan plan() const;
  std::vector<double> preset_genes() const;
  Parameters parameters(std::span<const double> genes) const;
};

struct SplitGeneratorController {
  using Parameters = networks::SplitGeneratorSteps;
  using State = networks::SplitGeneratorState;
  using Outputs = networks::ChildLevels;
  static constexpr auto output_kind = actuators::OutputKind::levels;

  networks::SplitGenerator preset;

  evolution::GenePlan plan() const;
  std::vector<double> preset_genes() const;
  Parameters parameters(std::span<const double> genes) const;
};

struct TonicController {
  using Parameters = networks::TonicSteps;
  using State = networks::TonicState;
  using Outputs = networks::ChildLevels;
  static constexpr auto output_kind = actuators::OutputKind::levels;

  networks::TonicNetwork preset;
  bool weights_evolve = false;

  evolution::GenePlan plan() const;
  std::vector<double> preset_genes() const;
  Parameters parameters(std::span<const double> genes) const;
};

static_assert(Controller<FourMotherController> && Controller<OneMotherController> &&
              Controller<RecurrentEightController> && Controller<TimedLoopController> &&
              Controller<SplitGeneratorController> && Controller<TonicController>);

}  // namespace lamprey::science::problems
