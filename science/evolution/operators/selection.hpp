#pragma once

#include "science/evolution/operators/word_sequence.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace lamprey::science::evolution::operators {

/// Positions by growing cost, the fittest first; of equals the earlier position, so that a tie is never left to chance.
std::vector<std::uint32_t> ranking(std::span<const double> costs);

/// How a parent is chosen (3.3.2.4, 3.3.2.5), by rank only: cost may be negative, and under the thesis's fitness it is.
/// - truncation: any of the fitter half is as likely;
/// - roulette: a member's slot on the wheel is as large as its rank from below: of n, the fittest has n of n(n + 1)/2;
/// - tournament: the fittest of `tournament_size` different members, any of which are as likely (fig. 3.11 has two).
enum class Selection : std::uint8_t { truncation, roulette, tournament };

/// The rank of a parent: 0 is the fittest of `members` ≥ 2 (at most 65,536). `tournament_size` is in 1..members.
std::uint32_t select_rank(Selection selection, std::uint32_t tournament_size, std::uint32_t members,
                          WordSequence& words);

}  // namespace lamprey::science::evolution::operators
