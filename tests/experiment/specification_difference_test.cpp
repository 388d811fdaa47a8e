#include "experiment/specification_difference.hpp"

#include "experiment/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::experiment {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> between(const std::string& stored, const std::string& given) {
  const auto first = parse_sweep(stored, "stored.yaml").specification;
  const auto second = parse_sweep(given, "given.yaml").specification;
  const auto lines = differences(first, second);
  EXPECT_EQ(lines.empty(), sweep_id(first) == sweep_id(second)) << stored << given;
  return lines;
}

TEST(SpecificationDifference, NamesEachFieldWithBothValues) {
  EXPECT_THAT(between(R"(name: a
seed: 2006
base: {cycles: 1000, acceptance: annealing, gait: walk}
grids:
  - {mutation_size: [25, 50, 75, 100], temperature: {from: 1, to: 3, step: 0.5}, steps: normal}
  - {steps: one_fifth_rule}
replicates: 3
)",
                      R"(name: b
seed: 2007
base: {cycles: 500, acceptance: annealing, posture: carry}
grids:
  - {mutation_size: [25, 50], temperature: {from: 1, to: 4, step: 0.5}, mutation: one}
)"),
              ElementsAre("name: a, now b", "seed: 2006, now 2007", "base.cycles: 1000, now 500",
                          "base.gait: walk, now not set", "base.posture: not set, now carry", "grids: 2, now 1",
                          "grids[0].mutation_size: 25, 50, 75, 100, now 25, 50",
                          "grids[0].temperature: 1 to 3 in steps of 0.5, now 1 to 4 in steps of 0.5",
                          "grids[0].steps: normal, now no axis", "grids[0].mutation: no axis, now one",
                          "replicates: 3, now 1"));
}

TEST(SpecificationDifference, IgnoresWhatIsNoPartOfTheSweep) {
  EXPECT_THAT(between("name: a\nbase: {acceptance: annealing, temperature: 1}\n",
                      "name: a\ndescription: another\npriority: 5\ntags: [x]\n"
                      "base: {temperature: 1.0, acceptance: annealing}\n"),
              IsEmpty());
}

TEST(SpecificationDifference, SeesAnotherOrderOfAxesAndARangeInThePlaceOfItsValues) {
  EXPECT_THAT(between("name: a\ngrids: [{mutation: [all, one], cycles: [1, 2]}]\n",
                      "name: a\ngrids: [{cycles: [1, 2], mutation: [all, one]}]\n"),
              ElementsAre("grids[0]: axes in the order mutation, cycles, now cycles, mutation"));
  EXPECT_THAT(
      between("name: a\ngrids: [{cycles: [1, 2]}]\n", "name: a\ngrids: [{cycles: {from: 1, to: 2, step: 1}}]\n"),
      ElementsAre("grids[0].cycles: 1, 2, now 1 to 2 in steps of 1"));
}

TEST(SpecificationDifference, FindsOneValueInALongListAndShortensOthers) {
  std::string list;
  for (int i = 1; i <= 100; ++i) list += (i > 1 ? ", " : "") + std::to_string(i);
  const auto sweep = [](const std::string& values) { return "name: a\ngrids: [{cycles: [" + values + "]}]\n"; };
  std::string changed = list;
  changed.replace(changed.find(", 50,"), 5, ", 500,");
  EXPECT_THAT(between(sweep(list), sweep(changed)), ElementsAre("grids[0].cycles[49]: 50, now 500"));
  EXPECT_THAT(between(sweep(list), sweep("7")),
              ElementsAre("grids[0].cycles: 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, ..., 100 (100 values), now 7"));
}

TEST(SpecificationDifference, CountsWhatItDoesNotSay) {
  std::string first;
  std::string second;
  for (int i = 1; i <= 100; ++i) {
    first += (i > 1 ? ", " : "") + std::to_string(i);
    second += (i > 1 ? ", " : "") + std::to_string(i + 1000);
  }
  const auto lines =
      between("name: a\ngrids: [{cycles: [" + first + "]}]\n", "name: a\ngrids: [{cycles: [" + second + "]}]\n");
  ASSERT_EQ(lines.size(), maximum_differences + 1);
  EXPECT_EQ(lines.back(), "and 80 more differences");
}

TEST(SpecificationDifference, ShowsTextOfUnknownParametersPrintably) {
  idl::SweepSpecification stored;
  auto& setting = *stored.add_base();
  setting.set_parameter("\x1b[2J");
  setting.mutable_value()->set_text("\x1b[2J");
  for (const auto& line : differences(stored, {})) EXPECT_EQ(line.find('\x1b'), std::string::npos) << line;
}

}  // namespace
}  // namespace lamprey::experiment
