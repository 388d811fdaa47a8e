#include "experiment/schedule.hpp"

#include "experiment/problem.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Messages are in sweep_file_cases; here is what a schedule means.

namespace lamprey::experiment {
namespace {

using testing::ElementsAre;

std::string canonical(const std::string& text) {
  return schedule_text(parse_schedule(text));
}

std::string refusal(const std::string& text) {
  try {
    parse_schedule(text);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "no refusal";
}

TEST(Schedule, IsReadIntoChangesByCycle) {
  const Schedule schedule = parse_schedule("500 required_distance=25 push_factor=0.5; 1000 required_stability=100");
  ASSERT_EQ(schedule.size(), 2U);
  EXPECT_EQ(schedule[0].cycle, 500U);
  EXPECT_THAT(schedule[0].values, ElementsAre(std::pair(parameter_index("required_distance"), Value(std::int64_t{25})),
                                              std::pair(parameter_index("push_factor"), Value(0.5))));
  EXPECT_EQ(schedule[1].cycle, 1000U);
  EXPECT_THAT(schedule[1].values,
              ElementsAre(std::pair(parameter_index("required_stability"), Value(std::int64_t{100}))));
}

TEST(Schedule, OfNothingNeverChanges) {
  EXPECT_EQ(parse_schedule(""), Schedule());
  EXPECT_EQ(parse_schedule(" \t\n"), Schedule());
  EXPECT_EQ(schedule_text({}), "");
}

TEST(Schedule, HasOneTextHoweverItIsWritten) {
  const std::string text = "500 required_distance=25 push_factor=0.5; 1000 required_stability=100";
  EXPECT_EQ(canonical(text), text);
  EXPECT_EQ(canonical("  500\tpush_factor=5e-1   required_distance=25 ;\n1000 required_stability=100 "), text);
  EXPECT_EQ(canonical("7 push_factor=1"), "7 push_factor=1") << "a whole number serves a real parameter";
  EXPECT_EQ(canonical("7 push_factor=-0"), "7 push_factor=0");
}

TEST(Schedule, MayChangeTheWeightsAndTheGround) {
  std::vector<std::string_view> names;
  for (const std::size_t row : environment_rows()) names.push_back(registry()[row].name);
  EXPECT_THAT(names, ElementsAre("required_stability", "required_distance", "required_fuel", "push_factor",
                                 "ground_level_front_left", "ground_level_front_right", "ground_level_back_left",
                                 "ground_level_back_right"));
}

TEST(Schedule, HasCyclesFromOneToTenMillion) {
  EXPECT_EQ(parse_schedule("1 required_fuel=1").front().cycle, 1U);
  EXPECT_EQ(parse_schedule("10000000 required_fuel=1").front().cycle, 10'000'000U);
  for (const auto* cycle : {"0", "-1", "10000001", "99999999999999999999", "1.5", "010", "+5", "0x10", "one"}) {
    EXPECT_NE(refusal(std::string(cycle) + " required_fuel=1"), "no refusal") << cycle;
  }
}

TEST(Schedule, HasValuesThatTheirParametersTake) {
  for (const auto* value : {"", "-1", "101", "2.5", "1e1", "010", "=1", "a", "1;"}) {
    EXPECT_NE(refusal(std::string("5 required_fuel=") + value), "no refusal") << value;
  }
  for (const auto* value : {"", "-0.1", "1.1", "nan", "inf", "1e999", "00.5"}) {
    EXPECT_NE(refusal(std::string("5 push_factor=") + value), "no refusal") << value;
  }
}

TEST(Schedule, HasAThousandChangesAtMost) {
  std::string text = "1 required_fuel=1";
  for (int cycle = 2; cycle <= 1000; ++cycle) text += ";" + std::to_string(cycle) + " required_fuel=1";
  EXPECT_EQ(parse_schedule(text).size(), 1000U);
  EXPECT_EQ(refusal(text + ";1001 required_fuel=1"), "environment: has more than 1000 changes");
}

TEST(Schedule, OfUnreadableTextIsRefusedReadably) {
  const std::string text = refusal("5 \xFF\x1B[31m=1;" + std::string(100'000, 'x'));
  EXPECT_LT(text.size(), 1000U);
  EXPECT_EQ(first_unreadable(text), std::string::npos);
}

}  // namespace
}  // namespace lamprey::experiment
