#include "science/problems/quadruped_controllers.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace lamprey::science::problems {

namespace {

using evolution::Gene;
using evolution::GenePlan;
using networks::children;

constexpr Gene time_gene{.minimum = networks::minimum_time, .maximum = networks::maximum_time};
constexpr Gene weight_gene{.minimum = -1, .maximum = 1, .step_unit = 0.2};
constexpr Gene threshold_gene{.minimum = 0, .maximum = 1, .step_unit = 0.1};
/// 9.3: a weight is how far a servo has to stretch; 2.5 in fig. 9.1.
constexpr Gene tonic_weight_gene{.minimum = 0, .maximum = 5, .step_unit = 0.5};
/// Its sign is the pulse.
constexpr Gene tonic_gene{.minimum = -1, .maximum = 1, .step_unit = 0.2, .whole = true};

constexpr std::array<Gene, 4> four_times{time_gene, time_gene, time_gene, time_gene};

void add_unit(GenePlan& plan, std::span<const Gene> genes) {
  std::vector<std::uint32_t>& unit = plan.units.emplace_back();
  for (const Gene& gene : genes) {
    unit.push_back(static_cast<std::uint32_t>(plan.genes.size()));
    plan.genes.push_back(gene);
  }
}

/// A unit of `genes` per child.
GenePlan plan_of_children(std::span<const Gene> genes) {
  GenePlan plan;
  for (std::size_t i = 0; i < children; ++i) add_unit(plan, genes);
  for (const auto& pair : networks::children_of_leg_pairs) plan.symmetric_units.emplace_back(pair.begin(), pair.end());
  for (const auto& kind : {networks::vertical_children, networks::horizontal_children}) {
    plan.kinds.emplace_back(kind.begin(), kind.end());
  }
  return plan;
}

template <std::size_t Count>
void append(std::vector<double>& genes, const std::array<double, Count>& values) {
  genes.insert(genes.end(), values.begin(), values.end());
}

/// The next genes of a vector, in order.
class Reader {
 public:
  explicit Reader(std::span<const double> genes) : genes_(genes) {}

  double next() {
    const double value = genes_.front();
    genes_ = genes_.subspan(1);
    return value;
  }
  template <std::size_t Count>
  void read(std::array<double, Count>& values) {
    std::copy_n(genes_.begin(), Count, values.begin());
    genes_ = genes_.subspan(Count);
  }

 private:
  std::span<const double> genes_;
};

std::vector<double> joined(const std::array<std::array<double, 4>, children>& times) {
  std::vector<double> genes;
  for (const auto& of_child : times) append(genes, of_child);
  return genes;
}

}  // namespace

GenePlan FourMotherController::plan() const {
  return plan_of_children(four_times);
}

std::vector<double> FourMotherController::preset_genes() const {
  return joined(preset.child_times);
}

networks::FourMotherSteps FourMotherController::parameters(std::span<const double> genes) const {
  networks::FourMotherNetwork network = preset;
  Reader reader(genes);
  for (auto& times : network.child_times) reader.read(times);
  return networks::whole_steps(network);
}

GenePlan OneMotherController::plan() const {
  GenePlan plan = plan_of_children(four_times);
  add_unit(plan, std::array{time_gene});
  return plan;
}

std::vector<double> OneMotherController::preset_genes() const {
  std::vector<double> genes = joined(preset.child_times);
  genes.push_back(preset.trigger_period);
  return genes;
}

networks::OneMotherSteps OneMotherController::parameters(std::span<const double> genes) const {
  networks::OneMotherNetwork network;
  Reader reader(genes);
  for (auto& times : network.child_times) reader.read(times);
  network.trigger_period = reader.next();
  return networks::whole_steps(network);
}

GenePlan RecurrentEightController::plan() const {
  return plan_of_children(
      std::array{time_gene, time_gene, time_gene, time_gene, weight_gene, weight_gene, weight_gene});
}

std::vector<double> RecurrentEightController::preset_genes() const {
  std::vector<double> genes;
  for (const auto& neuron : preset.neurons) {
    append(genes, neuron.times);
    append(genes, neuron.weights);
  }
  return genes;
}

networks::RecurrentEightSteps RecurrentEightController::parameters(std::span<const double> genes) const {
  networks::RecurrentEightNetwork network{.delay_refirings = preset.delay_refirings};
  Reader reader(genes);
  for (auto& neuron : network.neurons) {
    reader.read(neuron.times);
    reader.read(neuron.weights);
  }
  return networks::whole_steps(network);
}

GenePlan TimedLoopController::plan() const {
  return plan_of_children(four_times);
}

std::vector<double> TimedLoopController::preset_genes() const {
  return joined(preset.servo_times);
}

networks::TimedLoopSteps TimedLoopController::parameters(std::span<const double> genes) const {
  networks::TimedLoop loop{.period = preset.period};
  Reader reader(genes);
  for (auto& times : loop.servo_times) reader.read(times);
  return networks::whole_steps(loop);
}

GenePlan SplitGeneratorController::plan() const {
  GenePlan plan = plan_of_children(std::array{threshold_gene, time_gene, weight_gene, weight_gene});
  add_unit(plan, std::array{time_gene, time_gene});
  return plan;
}

std::vector<double> SplitGeneratorController::preset_genes() const {
  std::vector<double> genes;
  for (const auto& neuron : preset.pattern) {
    append(genes, std::array{neuron.threshold, neuron.time});
    append(genes, neuron.weights);
  }
  append(genes, std::array{preset.oscillator_on_time, preset.oscillator_off_time});
  return genes;
}

networks::SplitGeneratorSteps SplitGeneratorController::parameters(std::span<const double> genes) const {
  networks::SplitGenerator network;
  Reader reader(genes);
  for (auto& neuron : network.pattern) {
    neuron.threshold = reader.next();
    neuron.time = reader.next();
    reader.read(neuron.weights);
  }
  network.oscillator_on_time = reader.next();
  network.oscillator_off_time = reader.next();
  return networks::whole_steps(network);
}

GenePlan TonicController::plan() const {
  GenePlan plan;
  const std::array genes{tonic_gene, tonic_weight_gene};
  const std::size_t tuned = weights_evolve ? 2 : 1;
  for (std::size_t mother = 0; mother < networks::tonic_mothers; ++mother)
    add_unit(plan, std::span(genes).first(tuned));
  plan.kinds = {{networks::right_front, networks::right_back, networks::left_back, networks::left_front}};
  return plan;
}

std::vector<double> TonicController::preset_genes() const {
  std::vector<double> genes;
  for (std::size_t mother = 0; mother < networks::tonic_mothers; ++mother) {
    genes.push_back(preset.tonic[mother]);
    if (weights_evolve) genes.push_back(preset.weights[mother]);
  }
  return genes;
}

networks::TonicSteps TonicController::parameters(std::span<const double> genes) const {
  networks::TonicNetwork network = preset;
  Reader reader(genes);
  for (std::size_t mother = 0; mother < networks::tonic_mothers; ++mother) {
    network.tonic[mother] = networks::pulse_of_gene(reader.next());
    if (weights_evolve) network.weights[mother] = reader.next();
  }
  return networks::whole_steps(network);
}

}  // namespace lamprey::science::problems
