#include "science/evolution/mutation.hpp"

#include "science/maths/normal_deviate.hpp"

#include <algorithm>
#include <array>

namespace lamprey::science::evolution {

namespace {

constexpr std::size_t genes_of_a_block = 4;
using Steps = std::array<double, genes_of_a_block>;

Steps draw_steps(const StepDistribution& distribution, const random::Words& words) {
  Steps steps{};
  if (distribution.kind == StepDistribution::Kind::uniform) {
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = random::symmetric(words[i], distribution.size);
  } else {
    for (std::size_t i = 0; i < steps.size(); i += 2) {
      const auto [first, second] = maths::normal_deviates(words[i], words[i + 1]);
      steps[i] = first * distribution.standard_deviation;
      steps[i + 1] = second * distribution.standard_deviation;
    }
  }
  return steps;
}

}  // namespace

void mutate(const random::Stream& stream, std::uint32_t cycle, MutationTechnique technique,
            const StepDistribution& distribution, const GenePlan& plan, std::span<double> genes) {
  const auto mutate_unit = [&](std::size_t number) {
    const auto& unit = plan.units[number];
    for (std::size_t first = 0; first < unit.size(); first += genes_of_a_block) {
      const Steps steps =
          draw_steps(distribution, stream.block(cycle, random::Purpose::mutation, static_cast<std::uint32_t>(number),
                                                static_cast<std::uint32_t>(first / genes_of_a_block)));
      const std::size_t count = std::min(unit.size() - first, genes_of_a_block);
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t gene = unit[first + i];
        genes[gene] = held(plan.genes[gene], genes[gene] + steps[i] * plan.genes[gene].step_unit);
      }
    }
  };
  const auto choose = [&](std::size_t count) {
    const auto words = stream.block(cycle, random::Purpose::mutation_choice, 0);
    return random::bounded(words[0], static_cast<std::uint32_t>(count));
  };

  switch (technique) {
    case MutationTechnique::all:
      for (std::size_t unit = 0; unit < plan.units.size(); ++unit) mutate_unit(unit);
      break;
    case MutationTechnique::one:
      mutate_unit(choose(plan.units.size()));
      break;
    case MutationTechnique::some:
      for (const std::size_t unit : plan.symmetric_units[choose(plan.symmetric_units.size())]) mutate_unit(unit);
      break;
  }
}

}  // namespace lamprey::science::evolution
