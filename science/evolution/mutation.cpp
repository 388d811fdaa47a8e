#include "science/evolution/mutation.hpp"

#include "science/maths/normal_deviate.hpp"

#include <algorithm>

namespace lamprey::science::evolution {

namespace {

Unit draw_steps(const StepDistribution& distribution, const random::Words& words) {
  Unit steps{};
  if (distribution.kind == StepDistribution::Kind::uniform) {
    for (std::size_t gene = 0; gene < steps.size(); ++gene) {
      steps[gene] = random::symmetric(words[gene], distribution.size);
    }
  } else {
    for (std::size_t gene = 0; gene < steps.size(); gene += 2) {
      const auto [first, second] = maths::normal_deviates(words[gene], words[gene + 1]);
      steps[gene] = first * distribution.standard_deviation;
      steps[gene + 1] = second * distribution.standard_deviation;
    }
  }
  return steps;
}

}  // namespace

void mutate(const random::Stream& stream, std::uint32_t cycle, MutationTechnique technique,
            const StepDistribution& distribution, const GenePlan& plan, std::span<Unit> units) {
  const auto mutate_unit = [&](std::size_t unit) {
    const auto words = stream.block(cycle, random::Purpose::mutation, static_cast<std::uint32_t>(unit));
    const Unit steps = draw_steps(distribution, words);
    for (std::size_t gene = 0; gene < steps.size(); ++gene) {
      units[unit][gene] = std::min(std::max(units[unit][gene] + steps[gene], plan.minimum), plan.maximum);
    }
  };
  const auto choose = [&](std::size_t count) {
    const auto words = stream.block(cycle, random::Purpose::mutation_choice, 0);
    return random::bounded(words[0], static_cast<std::uint32_t>(count));
  };

  switch (technique) {
    case MutationTechnique::all:
      for (std::size_t unit = 0; unit < units.size(); ++unit) mutate_unit(unit);
      break;
    case MutationTechnique::one:
      mutate_unit(choose(units.size()));
      break;
    case MutationTechnique::some:
      for (const std::size_t unit : plan.symmetric_units[choose(plan.symmetric_units.size())]) mutate_unit(unit);
      break;
  }
}

}  // namespace lamprey::science::evolution
