#include "science/evolution/disturbance.hpp"

#include <algorithm>
#include <utility>

namespace lamprey::science::evolution {

void disturb(const random::Stream& stream, const Disturbance& disturbance, const UnitKinds& kinds, const GenePlan& plan,
             std::span<Unit> units) {
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    auto order = kinds[kind];
    const auto choice = stream.block(0, random::Purpose::disturbance_selection, static_cast<std::uint32_t>(kind));
    for (std::uint32_t i = 0; i < disturbance.per_kind; ++i) {
      const auto left = static_cast<std::uint32_t>(order.size()) - i;
      std::swap(order[i], order[i + random::bounded(choice[i], left)]);

      const auto words = stream.block(0, random::Purpose::disturbance, order[i]);
      Unit& unit = units[order[i]];
      for (std::size_t gene = 0; gene < unit.size(); ++gene) {
        const double moved = unit[gene] + random::symmetric(words[gene], disturbance.size);
        unit[gene] = std::min(std::max(moved, plan.minimum), plan.maximum);
      }
    }
  }
}

}  // namespace lamprey::science::evolution
