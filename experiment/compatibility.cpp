#include "experiment/compatibility.hpp"

namespace lamprey::experiment {

std::span<const Compatibility> compatibilities() {
  static const std::vector<Compatibility> rows = {
      {"network",
       {"recurrent_pair", "feed_forward_pair"},
       "robot",
       {"biped"},
       "two neurons move the two legs of the biped (6.2.2)"},
      {"robot",
       {"biped"},
       "network",
       {"recurrent_pair", "feed_forward_pair"},
       "the biped has two legs, one for each of two neurons (6.2.1)"},
      {"gait",
       {"walk_frames"},
       "network",
       {"one_mother", "recurrent_eight"},
       "the nine-step frames of fig. 7.13 are those of eight neurons and of one mother"},
      {"network",
       {"recurrent_eight"},
       "gait",
       {"walk", "walk_frames"},
       "its neurons and weights are shown for the walk only (7.4.2)"},
      {"network",
       {"split_generator"},
       "gait",
       {"trot", "pace", "gallop", "pronk"},
       "its one oscillator moves the legs in two groups at most (2.6.1)"},
      {"network", {"tonic"}, "gait", {"walk", "trot", "pace", "gallop"}, "the table of tonics has these (9.3)"},
      {"network", {"tonic"}, "trainer", {"rtea"}, "a change of gait is a mutation of the tonic input (9.3)"},
      {"gait",
       {"walk_frames"},
       "actuator",
       {"unit_move"},
       "its frames are compared output by output, so no servo has a part in them"},
      {"mutation",
       {"some"},
       "network",
       {"four_mother", "one_mother", "recurrent_eight", "split_generator", "timed_loop"},
       "it needs neurons that belong to pairs of legs (4.2.2)"},
      {"step_variance",
       {"root_error"},
       "objective",
       {"target"},
       "the root of the error needs a target: under maximise the error is minus the fitness"},
  };
  return rows;
}

}  // namespace lamprey::experiment
