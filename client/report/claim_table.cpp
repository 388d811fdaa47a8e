#include "client/report/claims.hpp"

#include <array>

namespace lamprey::client::report {

namespace {

/// Claims 1 to 7 rest on the published grid, in the reading of the defaults and in others; the same jobs are in one
/// sweep or in three.
const std::vector<Family> grid = {
    {{"thesis-chapter-8"}},      {{"mutate-all", "mutate-one", "mutate-some"}},
    {{"chapter-8-carry"}},       {{"chapter-8-total"}},
    {{"chapter-8-carry-total"}}, {{"appendix-b"}},
    {{"interpretations"}, true},
};
const std::vector<std::string> grid_readings = {"posture", "criterion", "temperature", "cycles"};
const std::vector<std::string> grid_columns = {"mutation",           "steps",
                                               "acceptance",         "equilibrium_disturbance",
                                               "mutation_size",      "system_disturbance",
                                               "required_stability", "required_distance",
                                               "required_fuel"};
const std::vector<std::string_view> totals = {"evolved_total", "highest_total"};

Claim grid_claim(int number, std::string_view statement, std::string_view thesis, std::vector<std::string_view> figures,
                 std::vector<Part> (*assess)(const Evidence&, const Reading&)) {
  return {number, statement, thesis, grid, grid_readings, grid_columns, false, totals, std::move(figures), assess};
}

}  // namespace

std::span<const Claim> claim_table() {
  static const std::array rows = {
      grid_claim(1, "Normal and uniform steps do equally well under every mutation technique.",
                 "8.3.1, 8.4, figs 8.3 to 8.5: fitness and success rates of normal and uniform steps are close.",
                 {"8-3", "8-4", "8-5"}, assess_normal_against_uniform),
      grid_claim(
          2,
          "Annealing beats simple acceptance in fitness and in success rate; only with it is the expected fitness "
          "nearly reached.",
          "8.3.1, figs 8.3 to 8.5: under annealing success rate and average fitness are higher, and only so was the "
          "expected fitness, or close to it, reached.",
          {"8-3", "8-4", "8-5"}, assess_annealing_against_simple),
      grid_claim(
          3, "With annealing mutate-one beats mutate-all; overall mutate-all beats mutate-one.",
          "8.4: mutate-one with annealing performed better than mutate-all with annealing, but overall mutate-all "
          "was better.",
          {"8-3", "8-4"}, assess_one_against_all),
      grid_claim(4, "Mutate-some is poor.", "8.3.1, 8.4, fig. 8.5: mutate-some performed poorly.", {"8-5"},
                 assess_some),
      grid_claim(5, "The 1/5 rule makes no significant difference.",
                 "8.3.3, 8.4, fig. 8.10: no significant difference from the other two operators.", {"8-10"},
                 assess_one_fifth_rule),
      grid_claim(
          6,
          "Under simple acceptance fitness falls as the disturbance grows, rises with the mutation size, and stays "
          "below 139.375.",
          "8.3.2.1, 8.3.2.3, figs 8.6 and 8.8.", {"8-6", "8-8"}, assess_simple_surfaces),
      grid_claim(
          7,
          "Under annealing fitness rises with both disturbance and mutation size under mutate-all; mutate-one and "
          "mutate-some show no such pattern.",
          "8.3.2.2, 8.3.2.4, figs 8.7 and 8.9.", {"8-7", "8-9"}, assess_annealing_surfaces),
      Claim{8,
            "Biped, II-RTEA: the feed-forward pair climbs gradually, the recurrent one jumps; feed-forward wins at 75 "
            "% and "
            "100 % and gains nothing at 25 %.",
            "6.2.2.7, figs 6.30 and 6.31.",
            {{{"figure-6-30"}}},
            {"posture"},
            {"network", "mutation_rate"},
            false,
            {"final_total"},
            {"6-30", "6-31"},
            assess_biped_real_time},
      Claim{9,
            "Biped, genetic algorithm: the recurrent pair is slightly ahead except at 25 %; networks with a threshold "
            "jump "
            "at low rates; the best mutation rate is near 75 %.",
            "6.2.2.4, 6.2.2.5, figs 6.25 to 6.27.",
            {{{"figure-6-25", "figure-6-27"}}},
            {"neuron", "weight_range"},
            {"network", "mutation_rate"},
            false,
            {"final_total"},
            {"6-25", "6-27"},
            assess_biped_population},
      Claim{10,
            "The recurrent network of eight neurons misses the wanted walk output; the single mother gives it.",
            "7.4.2, 7.4.3, figs 7.17 and 7.22.",
            {{{"figure-7-17", "figure-7-22"}}},
            {"delay_refirings"},
            {"network"},
            false,
            {"initial_stability"},
            {"7-17", "7-22"},
            assess_wanted_output},
      Claim{11,
            "Gait change: mutate-all and mutate-one both reach new gaits within tens of failures.",
            "9.4, figs 9.5 and 9.6: 1 and 14 failures with mutate-all, 18 and 1 with mutate-one.",
            {{{"figure-9-5", "figure-9-6"}}},
            {"posture"},
            {"mutation"},
            true,
            {"gait_change_failures"},
            {"9-5", "9-6"},
            assess_gait_change},
  };
  return rows;
}

}  // namespace lamprey::client::report
