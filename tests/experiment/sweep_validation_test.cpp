#include "experiment/sweep_validation.hpp"

#include "experiment/execution_validation.hpp"
#include "experiment/sweep.hpp"
#include "experiment/typed_value.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

// What a sender that is no sweep file can do; the messages that files can cause are in sweep_file_test.

namespace lamprey::experiment {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

idl::SweepSpecification empty_sweep() {
  idl::SweepSpecification specification;
  specification.set_name("test");
  specification.set_replicates(1);
  return specification;
}

idl::Value& add_base(idl::SweepSpecification& specification, const std::string& parameter) {
  auto& setting = *specification.add_base();
  setting.set_parameter(parameter);
  return *setting.mutable_value();
}

idl::Axis& add_axis(idl::Grid& grid, const std::string& parameter) {
  auto& axis = *grid.add_axes();
  axis.set_parameter(parameter);
  return axis;
}

std::vector<std::string> problems_of(const idl::SweepSpecification& specification) {
  std::vector<std::string> texts;
  for (const auto& problem : validate(specification)) texts.push_back(problem.text());
  return texts;
}

TEST(Validate, FindsNothingInAValidSpecification) {
  auto specification = empty_sweep();
  add_base(specification, "cycles").set_integer(10);
  add_axis(*specification.add_grids(), "mutation").add_values()->set_text("one");
  EXPECT_THAT(problems_of(specification), IsEmpty());
}

TEST(Validate, FindsWhatIsMissingInAnEmptyMessage) {
  EXPECT_THAT(problems_of({}),
              ElementsAre("name: no name is given: a name has 1 to 100 letters, digits, '-', '_' and '.'",
                          "replicates: 0 is out of range: replicates takes a whole number from 1 to 1000000"));
}

TEST(Validate, RefusesValuesWithoutAKind) {
  auto specification = empty_sweep();
  add_base(specification, "cycles");
  specification.add_base()->set_parameter("gait");
  auto& grid = *specification.add_grids();
  add_axis(grid, "mutation_size").mutable_range();
  EXPECT_THAT(
      problems_of(specification),
      ElementsAre("base.cycles: no value is given: cycles takes a whole number from 1 to 10000000",
                  "base.gait: no value is given: gait takes one of walk, trot, pace, gallop, pronk, walk_frames",
                  "grids[0].mutation_size.from: no value is given: mutation_size takes a whole number from 0 to "
                  "100 (%)",
                  "grids[0].mutation_size.to: no value is given: mutation_size takes a whole number from 0 to "
                  "100 (%)",
                  "grids[0].mutation_size.step: no value is given: mutation_size takes steps of a whole number "
                  "above 0"));
}

TEST(Validate, RefusesValuesOfTheWrongKind) {
  auto specification = empty_sweep();
  add_base(specification, "cycles").set_real(1000.0);
  add_base(specification, "gait").set_integer(1);
  add_base(specification, "acceptance").set_text("annealing");
  add_base(specification, "temperature").set_text("hot");
  EXPECT_THAT(problems_of(specification),
              ElementsAre("base.cycles: 1000 is not a whole number: cycles takes a whole number from 1 to 10000000",
                          "base.gait: 1 is not a name: gait takes one of walk, trot, pace, gallop, pronk, walk_frames",
                          "base.temperature: 'hot' is not a number: temperature takes a number from 1e-09 to 1e+09 "
                          "(fitness)"));
}

TEST(Validate, RefusesNumbersThatAreNotFinite) {
  for (const double value : {not_a_number, infinite, -infinite}) {
    auto specification = empty_sweep();
    add_base(specification, "acceptance").set_text("annealing");
    add_base(specification, "temperature").set_real(value);
    EXPECT_THAT(problems_of(specification), ElementsAre(HasSubstr("is not a number: temperature takes"))) << value;

    auto range_specification = empty_sweep();
    add_base(range_specification, "acceptance").set_text("annealing");
    auto& range = *add_axis(*range_specification.add_grids(), "temperature").mutable_range();
    range.mutable_from()->set_real(1);
    range.mutable_to()->set_real(value);
    range.mutable_step()->set_real(value);
    EXPECT_EQ(problems_of(range_specification).size(), 2U) << value;
  }
}

TEST(Validate, TakesAWholeNumberForARealParameter) {
  auto specification = empty_sweep();
  add_base(specification, "acceptance").set_text("annealing");
  add_base(specification, "temperature").set_integer(2);
  EXPECT_THAT(problems_of(specification), IsEmpty());
  EXPECT_EQ(SweepGrid(specification).job(0).parameters.real("temperature"), 2.0);
}

TEST(TypedValue, OfMinusZeroIsZero) {
  Parameter parameter = *find_parameter("temperature");
  parameter.minimum = -1;
  idl::Value value;
  value.set_real(-0.0);
  EXPECT_EQ(to_text(std::get<Value>(typed_value(parameter, value))), "0");
}

TEST(Validate, RefusesRepeatedSettingsAndAxes) {
  auto specification = empty_sweep();
  add_base(specification, "cycles").set_integer(1);
  add_base(specification, "cycles").set_integer(2);
  auto& grid = *specification.add_grids();
  add_axis(grid, "mutation").add_values()->set_text("all");
  add_axis(grid, "mutation").add_values()->set_text("one");
  EXPECT_THAT(problems_of(specification),
              ElementsAre("base.cycles: is set twice; keep one of them",
                          "grids[0].mutation: is an axis of this grid twice; keep one of them"));
}

TEST(Validate, RefusesAnAxisWithBothValuesAndARange) {
  auto specification = empty_sweep();
  auto& axis = add_axis(*specification.add_grids(), "mutation_size");
  axis.add_values()->set_integer(5);
  axis.mutable_range()->mutable_from()->set_integer(1);
  EXPECT_THAT(problems_of(specification),
              ElementsAre("grids[0].mutation_size: has both values and a range; keep one of them"));
}

TEST(Validate, RefusesAbsurdCountsWithoutExpandingThem) {
  auto ranges = empty_sweep();
  auto& range = *add_axis(*ranges.add_grids(), "cycles").mutable_range();
  range.mutable_from()->set_integer(1);
  range.mutable_to()->set_integer(10'000'000);
  range.mutable_step()->set_integer(1);
  EXPECT_THAT(problems_of(ranges), ElementsAre("grids[0].cycles: the range has too many values: the axes of a sweep "
                                               "hold at most 100000 values together"));

  auto lists = empty_sweep();
  auto& axis = add_axis(*lists.add_grids(), "cycles");
  for (int i = 0; i < 200'000; ++i) axis.add_values()->set_integer(i + 1);
  EXPECT_THAT(problems_of(lists), ElementsAre("grids[0].cycles: the list has too many values: the axes of a sweep "
                                              "hold at most 100000 values together"));

  auto grids = empty_sweep();
  for (int i = 0; i < 100'000; ++i) grids.add_grids();
  EXPECT_THAT(problems_of(grids), ElementsAre("grids: has 100000 grids; at most 1000 are allowed"));

  auto replicates = empty_sweep();
  replicates.set_replicates(std::numeric_limits<std::uint32_t>::max());
  EXPECT_THAT(problems_of(replicates), ElementsAre("replicates: 4294967295 is out of range: replicates takes a whole "
                                                   "number from 1 to 1000000"));
}

TEST(Validate, CountsJobsWithoutOverflow) {
  auto specification = empty_sweep();
  add_base(specification, "acceptance").set_text("annealing");
  auto& grid = *specification.add_grids();
  for (const auto* name : {"equilibrium_disturbance", "mutation_size", "system_disturbance", "required_stability",
                           "required_distance", "required_fuel", "cycles", "time_steps", "temperature"}) {
    auto& range = *add_axis(grid, name).mutable_range();
    range.mutable_from()->set_integer(1);
    range.mutable_to()->set_integer(100);
    range.mutable_step()->set_integer(1);
  }
  EXPECT_THAT(problems_of(specification),
              ElementsAre("grids: the sweep would have 1000000000000000000 jobs; at most 100000000 are allowed"));
  specification.set_replicates(1000);
  EXPECT_THAT(problems_of(specification),
              ElementsAre("grids: the sweep would have more than 10^19 jobs; at most 100000000 are allowed"));
  auto& range = *add_axis(grid, "cooling").mutable_range();
  range.mutable_from()->set_real(0.5);
  range.mutable_to()->set_real(1);
  range.mutable_step()->set_real(0.001);
  EXPECT_THAT(problems_of(specification),
              ElementsAre("grids: the sweep would have more than 10^19 jobs; at most 100000000 are allowed"));
}

TEST(Validate, TellsTooManyReplicatesFromTooManyCells) {
  auto specification = empty_sweep();
  auto& range = *add_axis(*specification.add_grids(), "cycles").mutable_range();
  range.mutable_from()->set_integer(1);
  range.mutable_to()->set_integer(101);
  range.mutable_step()->set_integer(1);
  specification.set_replicates(1'000'000);
  EXPECT_THAT(problems_of(specification),
              ElementsAre("replicates: the sweep would have 101000000 jobs; at most 100000000 are allowed"));
  specification.set_replicates(990'000);
  EXPECT_THAT(problems_of(specification), IsEmpty());
}

TEST(Validate, CutsHugeAndUnreadableTextInMessages) {
  auto specification = empty_sweep();
  add_base(specification, std::string(1 << 20, 'x')).set_text("y");
  add_base(specification, "gait").set_text("\x1B[31m\xFF" + std::string(1 << 20, 'z'));
  const auto problems = problems_of(specification);
  ASSERT_EQ(problems.size(), 2U);
  for (const auto& problem : problems) {
    EXPECT_LT(problem.size(), 1000U);
    EXPECT_EQ(first_unreadable(problem), std::string::npos);
  }
}

TEST(Validate, RefusesNamesAndDescriptionsThatCannotBeShown) {
  auto specification = empty_sweep();
  specification.set_name("a b");
  specification.set_description("\xFF\xFE");
  EXPECT_THAT(problems_of(specification),
              ElementsAre("name: 'a b' is not allowed: a name has 1 to 100 letters, digits, '-', '_' and '.'",
                          "description: '\\xff\\xfe' is not text in UTF-8, or has control characters"));
  specification.set_name(std::string(101, 'a'));
  specification.set_description(std::string(10'001, 'a'));
  EXPECT_THAT(problems_of(specification),
              ElementsAre(HasSubstr("name: 'aaa"), "description: has 10001 bytes; at most 10000 are allowed"));
  specification.set_name("0123456789abcdef0123456789abcdef");
  specification.clear_description();
  EXPECT_THAT(problems_of(specification), ElementsAre(HasSubstr("reads like a sweep's id")));
}

TEST(Validate, StopsAtAHundredProblems) {
  auto specification = empty_sweep();
  for (int i = 0; i < 100'000; ++i) add_base(specification, "unknown" + std::to_string(i)).set_integer(1);
  EXPECT_EQ(validate(specification).size(), maximum_problems);
}

TEST(Validate, DoesNotLookAtAxesThatWereLeftUnreadAfterAHundredProblems) {
  auto specification = empty_sweep();
  auto& grid = *specification.add_grids();
  add_axis(grid, "steps").add_values()->set_text("one_fifth_rule");
  add_axis(grid, "minimum_standard_deviation").add_values()->set_real(1);
  std::vector<Problem> found;
  for (std::size_t i = 0; i < maximum_problems; ++i) {
    found.push_back({.field = "field" + std::to_string(i), .message = "unknown", .file = ""});
  }
  EXPECT_EQ(validate(specification, ReadBefore{.problems = found, .grid_paths = {}}).size(), maximum_problems);
}

TEST(Validate, FindsNumbersThatATrainerCannotHaveTogether) {
  auto specification = empty_sweep();
  add_base(specification, "trainer").set_text("genetic_algorithm");
  add_base(specification, "selection").set_text("tournament");
  add_base(specification, "population").set_integer(8);
  add_base(specification, "tournament_size").set_integer(9);
  EXPECT_THAT(
      problems_of(specification),
      ElementsAre("base.tournament_size: tournament_size 9 contradicts population 8: a tournament has different "
                  "members of the population"));
  specification.clear_base();
  add_base(specification, "trainer").set_text("evolution_strategy");
  add_base(specification, "strategy").set_text("mu_comma_lambda");
  add_base(specification, "offspring").set_integer(39);
  EXPECT_THAT(problems_of(specification), ElementsAre(HasSubstr("population 40 contradicts offspring 39")));
  specification.mutable_base(1)->mutable_value()->set_text("mu_plus_lambda");
  EXPECT_THAT(problems_of(specification), testing::IsEmpty());
}

TEST(Validate, FindsContradictionsWithinTheBase) {
  auto specification = empty_sweep();
  add_base(specification, "steps").set_text("one_fifth_rule");
  add_base(specification, "minimum_standard_deviation").set_real(20);
  EXPECT_THAT(problems_of(specification),
              ElementsAre("base.minimum_standard_deviation: minimum_standard_deviation 20 contradicts "
                          "maximum_standard_deviation 10: the minimum must not be above the maximum"));
  specification.clear_base();
  add_base(specification, "objective").set_text("maximise");
  add_base(specification, "steps").set_text("normal");
  add_base(specification, "step_variance").set_text("root_error");
  EXPECT_THAT(problems_of(specification), ElementsAre(HasSubstr("step_variance root_error contradicts objective")));
}

TEST(Validate, FindsOverlapsWhateverParametersDecideThem) {
  const auto overlap = [](const std::string& first, const std::string& second, const std::string& base = "cycles: 9") {
    const std::string yaml = "name: a\nbase: {" + base + "}\ngrids:\n  - {" + first + "}\n  - {" + second + "}\n";
    try {
      parse_sweep(yaml, "a");
      return false;
    } catch (const InvalidInput& error) {
      EXPECT_THAT(error.what(), HasSubstr("grids[1]: has jobs that grids[0] has too")) << yaml;
      return true;
    }
  };
  EXPECT_FALSE(overlap("mutation: [all, one]", "mutation: [some]"));
  EXPECT_TRUE(overlap("mutation: [all, one]", "mutation: [some, one]"));
  EXPECT_TRUE(overlap("mutation: all", "steps: uniform")) << "both are the defaults";
  EXPECT_FALSE(overlap("mutation: one", "steps: uniform")) << "the second mutates all";
  EXPECT_TRUE(overlap("mutation_size: {from: 10, to: 90, step: 20}", "mutation_size: [20, 30]"));
  EXPECT_FALSE(overlap("mutation_size: {from: 10, to: 90, step: 20}", "mutation_size: [20, 40]"));
  EXPECT_TRUE(overlap("mutation_size: 50", "required_fuel: [50, 100]")) << "50 and 100 are the defaults";
  // A parameter that does not apply makes no difference: mutation_size under the 1/5 rule.
  EXPECT_TRUE(overlap("steps: [normal, one_fifth_rule], mutation_size: 20",
                      "steps: [uniform, one_fifth_rule], mutation_size: 30"));
  EXPECT_FALSE(
      overlap("steps: [normal, one_fifth_rule], mutation_size: 20", "steps: [uniform, normal], mutation_size: 30"));
  EXPECT_FALSE(overlap("acceptance: simple", "acceptance: annealing, temperature: [1, 2]"));
  EXPECT_TRUE(overlap("acceptance: [simple, annealing]", "acceptance: annealing, temperature: [1, 2]"));
  EXPECT_FALSE(
      overlap("acceptance: [simple, annealing], temperature: 3", "acceptance: annealing, temperature: [1, 2]"));
}

TEST(Validate, NamesAJobThatTwoGridsShare) {
  auto specification = empty_sweep();
  for (int i = 0; i < 3; ++i) {
    auto& grid = *specification.add_grids();
    add_axis(grid, "steps").add_values()->set_text("one_fifth_rule");
    add_axis(grid, "required_fuel").add_values()->set_integer(10 + i / 2);
  }
  EXPECT_THAT(
      problems_of(specification),
      ElementsAre("grids[1]: has jobs that grids[0] has too (such as steps one_fifth_rule, required_fuel 10); a "
                  "sweep runs each job once"));
}

TEST(Validate, ComparesTheLargestAllowedGridsInTime) {
  auto specification = empty_sweep();
  for (int i = 0; i < maximum_grids; ++i) {
    auto& range = *add_axis(*specification.add_grids(), "cycles").mutable_range();
    range.mutable_from()->set_integer(1 + 100 * i);
    range.mutable_to()->set_integer(100 + 100 * i);
    range.mutable_step()->set_integer(1);
  }
  EXPECT_THAT(problems_of(specification), IsEmpty());
  EXPECT_EQ(SweepGrid(specification).jobs(), 100'000U);
  EXPECT_EQ(SweepGrid(specification).job(99'999).parameters.integer("cycles"), 100'000);
}

TEST(Validate, MakesSchedulesCanonicalWhoeverSendsThem) {
  auto specification = empty_sweep();
  add_base(specification, "objective").set_text("maximise");
  add_base(specification, "environment").set_text(" 5 push_factor=0.50   required_fuel=1;");
  EXPECT_THAT(problems_of(specification), ElementsAre(HasSubstr("base.environment: a change is missing")));
  specification.mutable_base(1)->mutable_value()->set_text(" 5  push_factor=0.50   required_fuel=1");
  const Id128 id = sweep_id(specification);
  EXPECT_EQ(SweepGrid(specification).job(0).parameters.choice("environment"), "5 required_fuel=1 push_factor=0.5");
  specification.mutable_base(1)->mutable_value()->set_text("5 required_fuel=1 push_factor=0.5");
  EXPECT_EQ(sweep_id(specification), id);
  specification.mutable_base(1)->mutable_value()->set_integer(5);
  EXPECT_THAT(problems_of(specification), ElementsAre(HasSubstr("base.environment: 5 is not text: environment takes "
                                                                "changes at cycles, such as '500 required_distance")));
}

TEST(Validate, ComparesSchedulesOfAnAxis) {
  auto specification = empty_sweep();
  auto& grid = *specification.add_grids();
  add_axis(grid, "objective").add_values()->set_text("maximise");
  auto& axis = add_axis(grid, "environment");
  axis.add_values()->set_text("");
  axis.add_values()->set_text("5 required_fuel=1");
  EXPECT_THAT(problems_of(specification), IsEmpty());
  EXPECT_EQ(SweepGrid(specification).job(0).parameters.choice("environment"), "");
  axis.add_values()->set_text("5  required_fuel=1");
  EXPECT_THAT(problems_of(specification),
              ElementsAre("grids[0].environment[2]: 5 required_fuel=1 is in this axis twice"));
}

// Every pair of grids is compared, and what decides whether they share a job are many choices with many values.
TEST(Validate, ComparesGridsOfManyChoicesInTime) {
  auto specification = empty_sweep();
  add_base(specification, "acceptance").set_text("annealing");
  for (int i = 0; i < 300; ++i) {
    auto& grid = *specification.add_grids();
    for (const auto* name : {"mutation", "steps", "objective", "criterion", "posture", "record"}) {
      auto& axis = add_axis(grid, name);
      for (const auto choice : find_parameter(name)->choices) axis.add_values()->set_text(std::string(choice));
    }
    for (const auto* network : {"four_mother", "one_mother", "timed_loop"}) {
      if (grid.axes_size() == 6) add_axis(grid, "network");
      grid.mutable_axes(6)->add_values()->set_text(network);
    }
    // It applies in every cell, so that it alone tells the grids apart.
    add_axis(grid, "temperature").add_values()->set_real(1 + i);
  }
  EXPECT_THAT(problems_of(specification), IsEmpty());
  specification.mutable_grids(299)->mutable_axes(7)->mutable_values(0)->set_real(1);
  EXPECT_THAT(problems_of(specification), ElementsAre(HasSubstr("grids[299]: has jobs that grids[0] has too")));
}

TEST(Validate, ChecksHowASweepIsRun) {
  auto specification = empty_sweep();
  auto& execution = *specification.mutable_execution();
  EXPECT_THAT(problems_of(specification), IsEmpty()) << "0 stands for the default everywhere";
  execution.set_priority(-1001);
  execution.set_max_concurrent(100'000'001);
  execution.set_time_limit(not_a_number);
  execution.set_attempts(101);
  for (const double value : {infinite, 1.0, 2.0}) {
    auto& condition = *execution.add_stop_when();
    condition.set_measure("final_total");
    condition.set_at_least(value);
  }
  execution.add_stop_when()->set_measure("\x1b[2J");
  execution.add_needs("");
  execution.add_needs(std::string(65, 'a'));
  for (int i = 0; i < 17; ++i) execution.add_tags("t" + std::to_string(i));
  const auto problems = problems_of(specification);
  EXPECT_THAT(
      problems,
      ElementsAre("priority: -1001 is out of range: priority takes a whole number from -1000 to 1000",
                  "max_concurrent: 100000001 is out of range: max_concurrent takes a whole number from 1 to 100000000",
                  "time_limit: nan is out of range: time_limit takes a number of seconds above 0 and up to 31536000",
                  "attempts: 101 is out of range: attempts takes a whole number from 1 to 100",
                  "stop_when.final_total: inf is out of range: final_total takes a number",
                  "stop_when.final_total: is given twice; keep one of them",
                  HasSubstr("stop_when.\\x1b[2J: unknown measure '\\x1b[2J'"), HasSubstr("needs[0]: '' is not allowed"),
                  HasSubstr("needs[1]: 'aaa"), "tags: has 17 tags; at most 16 are allowed"));
  EXPECT_EQ(validate(execution).size(), problems.size());
}

TEST(Validate, LooksAtAHundredConditionsToStopAtMost) {
  auto specification = empty_sweep();
  for (int i = 0; i < 100'000; ++i) {
    specification.mutable_execution()->add_stop_when()->set_measure("m" + std::to_string(i));
  }
  EXPECT_EQ(validate(specification).size(), maximum_problems);
}

}  // namespace
}  // namespace lamprey::experiment
