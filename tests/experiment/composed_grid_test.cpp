#include "experiment/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Grids with a `zip` or a `where`: which plain grids they stand for, and what is said about those.

namespace lamprey::experiment {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

idl::SweepSpecification sweep(const std::string& grids, const std::string& base = "cycles: 9") {
  return parse_sweep("name: a\nbase: {" + base + "}\ngrids:\n" + grids, "sweep.yaml").specification;
}

std::string refusal(const std::string& grids) {
  try {
    sweep(grids);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "no refusal";
}

/// The jobs in order, each as the values of the parameters; "-" where one does not apply.
std::vector<std::string> jobs(const idl::SweepSpecification& specification, const std::vector<std::string>& names) {
  const SweepGrid grid(specification);
  std::vector<std::string> texts;
  for (std::uint64_t number = 0; number < grid.jobs(); ++number) {
    const auto parameters = grid.job(number).parameters;
    std::string text;
    for (const auto& name : names) {
      text += text.empty() ? "" : " ";
      text += parameters.applies(parameter_index(name)) ? to_text(parameters.get(name)) : "-";
    }
    texts.push_back(text);
  }
  return texts;
}

TEST(Zip, AdvancesItsParametersTogetherMoreSlowlyThanTheAxes) {
  EXPECT_THAT(jobs(sweep("  - mutation: [all, one]\n"
                         "    zip: {required_stability: [25, 100, 25], required_distance: [100, 25, 50]}\n"),
                   {"mutation", "required_stability", "required_distance"}),
              ElementsAre("all 25 100", "one 25 100", "all 100 25", "one 100 25", "all 25 50", "one 25 50"));
}

TEST(Zip, OfOneParameterIsItsSlowestAxis) {
  EXPECT_THAT(
      jobs(sweep("  - mutation: [all, one]\n    zip: {required_fuel: [1, 2]}\n"), {"mutation", "required_fuel"}),
      ElementsAre("all 1", "one 1", "all 2", "one 2"));
}

TEST(Where, LeavesAnAxisOutWhereItDoesNotApply) {
  EXPECT_THAT(
      jobs(sweep("  - steps: [uniform, one_fifth_rule, normal]\n"
                 "    mutation_size: {values: [25, 50], where: {steps: [normal, uniform]}}\n"
                 "    mutation: [all, one]\n"),
           {"steps", "mutation_size", "mutation"}),
      ElementsAre("uniform 25 all", "uniform 25 one", "uniform 50 all", "uniform 50 one", "normal 25 all",
                  "normal 25 one", "normal 50 all", "normal 50 one", "one_fifth_rule - all", "one_fifth_rule - one"))
      << "values that belong together stay together, in the order of the first of each group";
}

TEST(Where, TakesARangeAndASingleValue) {
  EXPECT_THAT(jobs(sweep("  - acceptance: [simple, annealing]\n"
                         "    cooling: {from: 0.8, to: 1, step: 0.1, where: {acceptance: annealing}}\n"),
                   {"acceptance", "cooling"}),
              ElementsAre("simple -", "annealing 0.8", "annealing 0.9", "annealing 1"));
}

TEST(Where, OfSeveralAxesHoldsWhereAllDo) {
  EXPECT_THAT(
      jobs(sweep("  - mutation: [all, one]\n"
                 "    acceptance: [simple, annealing]\n"
                 "    required_fuel: {values: [1, 2], where: {mutation: one, acceptance: annealing}}\n"),
           {"mutation", "acceptance", "required_fuel"}),
      ElementsAre("all simple 100", "all annealing 100", "one simple 100", "one annealing 1", "one annealing 2"))
      << "elsewhere the parameter has its default";
}

TEST(Where, MayReferToAnAxisThatHasOneItself) {
  EXPECT_THAT(jobs(sweep("  - trainer: [rtea, genetic_algorithm]\n"
                         "    crossover: {values: [one_point, blx_alpha], where: {trainer: genetic_algorithm}}\n"
                         "    blend_alpha: {values: [0.25, 0.5], where: {crossover: blx_alpha}}\n"),
                   {"trainer", "crossover", "blend_alpha"}),
              ElementsAre("rtea - -", "genetic_algorithm one_point -", "genetic_algorithm blx_alpha 0.25",
                          "genetic_algorithm blx_alpha 0.5"));
}

TEST(Where, MayReferToAZip) {
  EXPECT_THAT(jobs(sweep("  - zip: {steps: [normal, one_fifth_rule], mutation: [one, all]}\n"
                         "    mutation_size: {values: [25, 50], where: {steps: normal}}\n"),
                   {"steps", "mutation", "mutation_size"}),
              ElementsAre("normal one 25", "normal one 50", "one_fifth_rule all -"));
}

TEST(ComposedGrid, IsTheSameSweepAsThePlainGridsThatItStandsFor) {
  const auto composed = sweep(
      "  - mutation: [all, one, some]\n"
      "    steps: [uniform, normal, one_fifth_rule]\n"
      "    mutation_size: {values: [25, 50], where: {steps: [uniform, normal]}}\n"
      "    system_disturbance: {values: [50, 100], where: {mutation: [all, one]}}\n");
  const auto plain = sweep(
      "  - {mutation: [all, one], steps: [uniform, normal], mutation_size: [25, 50], system_disturbance: [50, 100]}\n"
      "  - {mutation: [all, one], steps: [one_fifth_rule], system_disturbance: [50, 100]}\n"
      "  - {mutation: [some], steps: [uniform, normal], mutation_size: [25, 50]}\n"
      "  - {mutation: [some], steps: [one_fifth_rule]}\n");
  EXPECT_EQ(sweep_id(composed), sweep_id(plain));
  EXPECT_EQ(SweepGrid(composed).jobs(), SweepGrid(plain).jobs());
}

TEST(ComposedGrid, IsNamedAsInTheFileWhateverItStandsFor) {
  EXPECT_EQ(refusal("  - zip: {required_fuel: [1, 2, 3]}\n"
                    "  - {required_fuel: [4, 5]}\n"
                    "  - {required_fuel: [3, 6]}\n"),
            "sweep.yaml:6:5: grids[2]: has jobs that grids[0] has too (such as required_fuel 3); a sweep runs each "
            "job once");
  EXPECT_EQ(refusal("  - zip: {required_fuel: [1, 2, 3]}\n"
                    "    cycles: [10, 20]\n"),
            "sweep.yaml:5:5: grids[0].cycles: is set in base too; keep one of them")
      << "said once, not for each of the three grids";
}

TEST(ComposedGrid, ThatCannotBeReadHidesNothingAboutTheOthers) {
  EXPECT_EQ(refusal("  - zip: {required_fuel: [1, 2], required_distance: [1]}\n"
                    "  - {mutation: [all, two]}\n"),
            "sweep.yaml:4:34: grids[0].zip.required_distance: has 1 value, but required_fuel has 2 values: the lists "
            "of a zip advance together\n"
            "sweep.yaml:5:22: grids[1].mutation[1]: 'two' is not known: mutation takes one of all, one, some");
}

TEST(ComposedGrid, StandsForAThousandGridsAtMost) {
  const auto zip = [](int rows) {
    std::string list;
    for (int i = 1; i <= rows; ++i) list += std::to_string(i) + ",";
    return "  - zip: {time_steps: [" + list + "]}\n";
  };
  EXPECT_EQ(SweepGrid(sweep(zip(1000))).jobs(), 1000U);
  EXPECT_THAT(refusal(zip(1001)), HasSubstr("grids[0]: stands for too many plain grids: a sweep has at most 1000"));
  EXPECT_THAT(refusal(zip(600) + zip(600)), HasSubstr("grids[1]: stands for too many plain grids"));
}

TEST(ComposedGrid, HasAsManyValuesAsOtherGridsAtMost) {
  std::string rows;
  std::string values;
  for (int i = 1; i <= 900; ++i) rows += std::to_string(i) + ",";
  for (int i = 1; i <= 5000; ++i) values += std::to_string(i) + ",";
  EXPECT_THAT(refusal("  - zip: {time_steps: [" + rows + "]}\n    success_window: [" + values + "]\n"),
              HasSubstr("with 100000 values on all their axes together"));
}

}  // namespace
}  // namespace lamprey::experiment
