#include "science/evolution/disturbance.hpp"

#include "science/evolution/operators/uniform_mutation.hpp"

#include <utility>

namespace lamprey::science::evolution {

namespace {

constexpr std::uint32_t words_of_a_block = 4;

void disturb_unit(const random::Stream& stream, std::uint32_t member, int size, const GenePlan& plan,
                  std::uint32_t number, std::span<double> genes) {
  const auto& unit = plan.units[number];
  random::Words words{};
  for (std::uint32_t i = 0; i < unit.size(); ++i) {
    if (i % words_of_a_block == 0) {
      words = stream.block(member, random::Purpose::disturbance, number, i / words_of_a_block);
    }
    const Gene& gene = plan.genes[unit[i]];
    const double step = random::symmetric(words[i % words_of_a_block], size) * gene.step_unit;
    genes[unit[i]] = held(gene, genes[unit[i]] + step);
  }
}

}  // namespace

void disturb(const random::Stream& stream, std::uint32_t member, const Disturbance& disturbance, const GenePlan& plan,
             std::span<double> genes) {
  for (std::size_t kind = 0; kind < plan.kinds.size(); ++kind) {
    auto order = plan.kinds[kind];
    const auto units = static_cast<std::uint32_t>(order.size());
    const auto disturbed = static_cast<std::uint32_t>(units * disturbance.percent / 100);
    random::Words choice{};
    for (std::uint32_t i = 0; i < disturbed; ++i) {
      if (i % words_of_a_block == 0) {
        choice = stream.block(member, random::Purpose::disturbance_selection, static_cast<std::uint32_t>(kind),
                              i / words_of_a_block);
      }
      std::swap(order[i], order[i + random::bounded(choice[i % words_of_a_block], units - i)]);
      disturb_unit(stream, member, disturbance.size, plan, order[i], genes);
    }
  }
}

std::vector<double> initial_genes(const Problem& problem, const Disturbance& disturbance, const random::Stream& stream,
                                  std::uint32_t member) {
  const auto preset = problem.preset();
  if (preset.empty()) return operators::draw_genes(stream, member, problem.plan());
  std::vector<double> genes(preset.begin(), preset.end());
  disturb(stream, member, disturbance, problem.plan(), genes);
  return genes;
}

}  // namespace lamprey::science::evolution
