#pragma once

#include "science/gaits/gait.hpp"
#include "science/networks/four_mother.hpp"
#include "science/networks/one_mother.hpp"
#include "science/networks/recurrent_eight.hpp"
#include "science/networks/split_generator.hpp"
#include "science/networks/timed_loop.hpp"
#include "science/networks/tonic.hpp"

namespace lamprey::science::gaits {

// The parameters with which each network makes each gait. All throw std::invalid_argument for a gait of which there is
// no preset for that network.

/// All gaits but walk_frames. The thesis's walk is in walk.hpp. The others have a period of 25 time steps: a leg lifts
/// for four and lands for four while it swings forward for eight; the second group follows when the first has landed;
/// then all push back together for eight; one step of rest. S, D and F over 100 steps: trot 64/192/77.6, pace
/// 64/192/58.4, gallop 64/192/71.2, pronk 0/192/68.
networks::FourMotherNetwork four_mother(Gait gait);

/// All gaits. walk_frames are the times of fig. 7.13(a) with T_D = 9, walk the same ten times as long (fig. 7.12) with
/// T_D = 100: 80/60/83 as with four mothers. The others move every servo when four_mother does.
networks::OneMotherNetwork one_mother(Gait gait);

/// walk and walk_frames: the times of one_mother with every weight −1 (7.4.2). It does not walk as wanted: triggered by
/// each other, the neurons fire where they should rest (fig. 7.17).
networks::RecurrentEightNetwork recurrent_eight(Gait gait, bool delay_refirings);

/// All gaits but walk_frames: every servo moves when it does in four_mother, to the step.
networks::TimedLoop timed_loop(Gait gait);

/// Trot, pace, gallop and pronk; two phases of an oscillator cannot time four legs in turn. The oscillator is the
/// biped's perfect antiphase of ten steps (6.2.1); a leg lifts for four steps and swings for eight from its group's
/// beat on.
networks::SplitGenerator split_generator(Gait gait);

/// Walk, gallop, trot and pace: the table of 9.3, with the weights of 2.5 of fig. 9.1.
networks::TonicNetwork tonic(Gait gait);

}  // namespace lamprey::science::gaits
