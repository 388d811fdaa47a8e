#include "experiment/parameters.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace lamprey::experiment {
namespace {

template <typename Number>
Number parse(const std::string& text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  EXPECT_EQ(error, std::errc()) << text;
  EXPECT_EQ(end, text.data() + text.size()) << text;
  return number;
}

TEST(Registry, HasItsParametersInTheOrderInWhichPeopleReadThem) {
  std::vector<std::string_view> names;
  for (const auto& parameter : registry()) names.push_back(parameter.name);
  EXPECT_THAT(names, testing::ElementsAreArray({"robot",
                                                "network",
                                                "neuron",
                                                "weight_range",
                                                "gait",
                                                "delay_refirings",
                                                "tonic_genes",
                                                "actuator",
                                                "integrator_time_constant",
                                                "actuator_stroke",
                                                "reflex_gain",
                                                "reflex_damping",
                                                "trainer",
                                                "mutation",
                                                "steps",
                                                "acceptance",
                                                "equilibrium_disturbance",
                                                "mutation_size",
                                                "system_disturbance",
                                                "required_stability",
                                                "required_distance",
                                                "required_fuel",
                                                "push_factor",
                                                "ground_level_front_left",
                                                "ground_level_front_right",
                                                "ground_level_back_left",
                                                "ground_level_back_right",
                                                "cycles",
                                                "time_steps",
                                                "objective",
                                                "criterion",
                                                "posture",
                                                "environment",
                                                "record",
                                                "temperature",
                                                "cooling",
                                                "step_variance",
                                                "first_standard_deviation",
                                                "success_window",
                                                "standard_deviation_factor",
                                                "minimum_standard_deviation",
                                                "maximum_standard_deviation",
                                                "mutation_rate",
                                                "population",
                                                "selection",
                                                "tournament_size",
                                                "crossover",
                                                "blend_alpha",
                                                "strategy",
                                                "offspring",
                                                "first_step",
                                                "first_temperature",
                                                "temperature_factor",
                                                "hybrid_share"}));
}

TEST(Registry, NamesAreSnakeCaseAndUnique) {
  std::set<std::string_view> names;
  for (const auto& parameter : registry()) {
    EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name;
    EXPECT_TRUE(parameter.name[0] >= 'a' && parameter.name[0] <= 'z') << parameter.name;
    EXPECT_EQ(parameter.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string_view::npos)
        << parameter.name;
  }
}

TEST(Registry, NamesAreNotColumnsThatTheResultsHaveAnyway) {
  const std::set<std::string_view> reserved = {"sweep",        "job",    "state",     "digest",
                                               "attempt",      "worker", "seconds",   "repeatability",
                                               "success_rate", "seed",   "replicate", "identity"};
  for (const auto& parameter : registry()) {
    EXPECT_FALSE(reserved.contains(parameter.name)) << parameter.name;
    for (const auto prefix : {"expected_", "initial_", "evolved_", "highest_", "final_"}) {
      EXPECT_FALSE(parameter.name.starts_with(prefix)) << parameter.name;
    }
  }
}

TEST(Registry, RowsSayWhatTheyMeanAndWhereItComesFrom) {
  for (const auto& parameter : registry()) {
    EXPECT_TRUE(parameter.meaning.ends_with(".")) << parameter.name;
    EXPECT_FALSE(parameter.source.empty()) << parameter.name;
  }
}

TEST(Registry, DefaultsAreOfTheirKindAndWithinTheirRange) {
  for (const auto& parameter : registry()) {
    SCOPED_TRACE(parameter.name);
    if (parameter.kind == ParameterKind::choice) {
      ASSERT_FALSE(parameter.choices.empty());
      EXPECT_EQ(std::get<std::string>(parameter.default_value), parameter.choices.front());
      const std::set<std::string_view> unique(parameter.choices.begin(), parameter.choices.end());
      EXPECT_EQ(unique.size(), parameter.choices.size());
      continue;
    }
    EXPECT_TRUE(parameter.choices.empty());
    if (parameter.kind == ParameterKind::schedule) {
      EXPECT_EQ(std::get<std::string>(parameter.default_value), "") << "never changes";
      continue;
    }
    EXPECT_LT(parameter.minimum, parameter.maximum);
    const double value = parameter.kind == ParameterKind::integer
                             ? static_cast<double>(std::get<std::int64_t>(parameter.default_value))
                             : std::get<double>(parameter.default_value);
    EXPECT_GE(value, parameter.minimum);
    EXPECT_LE(value, parameter.maximum);
  }
}

// Identities and messages write names and choices without quoting them.
TEST(Registry, ChoicesNeedNoQuoting) {
  for (const auto& parameter : registry()) {
    for (const auto choice : parameter.choices) {
      EXPECT_FALSE(choice.empty()) << parameter.name;
      EXPECT_EQ(choice.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string_view::npos) << choice;
    }
  }
}

// Which parameters apply is decided in one pass over the rows.
TEST(Registry, ConditionsNameChoicesOfEarlierRows) {
  for (std::size_t row = 0; row < registry().size(); ++row) {
    SCOPED_TRACE(registry()[row].name);
    for (const auto& condition : registry()[row].applies_when) {
      const Parameter* other = find_parameter(condition.parameter);
      ASSERT_NE(other, nullptr) << condition.parameter;
      EXPECT_LT(parameter_index(condition.parameter), row) << condition.parameter;
      EXPECT_EQ(other->kind, ParameterKind::choice);
      EXPECT_FALSE(condition.values.empty());
      for (const auto value : condition.values) {
        EXPECT_NE(std::ranges::find(other->choices, value), other->choices.end()) << value;
      }
    }
  }
}

TEST(Registry, HasNoConditionThatNeverFailsOrNeverHolds) {
  for (const auto& parameter : registry()) {
    SCOPED_TRACE(parameter.name);
    for (const auto& condition : parameter.applies_when) {
      const std::set<std::string_view> values(condition.values.begin(), condition.values.end());
      EXPECT_EQ(values.size(), condition.values.size()) << condition.parameter;
      EXPECT_LT(values.size(), find_parameter(condition.parameter)->choices.size()) << condition.parameter;
    }
  }
}

TEST(Registry, ValuesReadBackFromTheirText) {
  for (const auto& parameter : registry()) {
    SCOPED_TRACE(parameter.name);
    if (parameter.kind == ParameterKind::integer) {
      for (const auto value :
           {static_cast<std::int64_t>(parameter.minimum), static_cast<std::int64_t>(parameter.maximum)}) {
        EXPECT_EQ(parse<std::int64_t>(to_text(Value(value))), value);
      }
    } else if (parameter.kind == ParameterKind::real) {
      for (const double value : {parameter.minimum, parameter.maximum, (parameter.minimum + parameter.maximum) / 3}) {
        EXPECT_EQ(parse<double>(to_text(Value(value))), value);
      }
    }
  }
}

TEST(Registry, RowsAreFoundByName) {
  for (std::size_t row = 0; row < registry().size(); ++row) {
    EXPECT_EQ(find_parameter(registry()[row].name), &registry()[row]);
    EXPECT_EQ(parameter_index(registry()[row].name), row);
  }
  EXPECT_EQ(find_parameter("gaitt"), nullptr);
  EXPECT_EQ(find_parameter(""), nullptr);
  EXPECT_THROW(parameter_index("gaitt"), std::out_of_range);
}

std::string values_column(const Parameter& parameter) {
  std::string text;
  if (parameter.kind == ParameterKind::choice) {
    for (const auto choice : parameter.choices) text += (text.empty() ? "`" : ", `") + std::string(choice) + "`";
    return text;
  }
  if (parameter.kind == ParameterKind::schedule) return "schedule ([sweep_file.md](sweep_file.md))";
  if (parameter.kind == ParameterKind::integer) {
    text = "whole, " + to_text(Value(static_cast<std::int64_t>(parameter.minimum))) + " to " +
           to_text(Value(static_cast<std::int64_t>(parameter.maximum)));
  } else {
    text = "real, " + to_text(Value(parameter.minimum)) + " to " + to_text(Value(parameter.maximum));
  }
  return parameter.unit.empty() ? text : text + " " + std::string(parameter.unit);
}

std::string applies_column(const Parameter& parameter) {
  std::string text;
  for (const auto& condition : parameter.applies_when) {
    if (!text.empty()) text += " and ";
    text += (condition.is ? "if `" : "unless `") + std::string(condition.parameter) + "` is ";
    for (const auto value : condition.values) {
      text += (value == condition.values.front() ? "`" : " or `") + std::string(value) + "`";
    }
  }
  return text.empty() ? "always" : text;
}

std::string table_row(const Parameter& parameter) {
  return "| `" + std::string(parameter.name) + "` | " + std::string(parameter.meaning) + " | " +
         values_column(parameter) + " | " +
         (to_text(parameter.default_value).empty() ? "none" : to_text(parameter.default_value)) + " | " +
         applies_column(parameter) + " | " + std::string(parameter.source) + " |";
}

TEST(Registry, IsWhatItsDocumentationSays) {
  std::ifstream file(LAMPREY_SOURCE_DIR "/docs/formats/parameters.md");
  ASSERT_TRUE(file);
  std::vector<std::string> documented;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("| `")) documented.push_back(line);
  }
  std::vector<std::string> rows;
  std::string all_rows;
  for (const auto& parameter : registry()) {
    rows.push_back(table_row(parameter));
    all_rows += rows.back() + '\n';
  }
  EXPECT_EQ(documented, rows) << "docs/formats/parameters.md should have these rows:\n" << all_rows;
}

}  // namespace
}  // namespace lamprey::experiment
