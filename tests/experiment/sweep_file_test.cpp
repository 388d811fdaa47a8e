#include "experiment/sweep.hpp"
#include "experiment/yaml_tree.hpp"
#include "sweep_file_cases.hpp"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace lamprey::experiment {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

/// All that is said about a wrong file.
std::string refusal(const std::string& yaml) {
  try {
    parse_sweep(yaml, "sweep.yaml");
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "no refusal";
}

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string documented(const WrongSweepFile& wrong) {
  return "**" + std::string(wrong.title) + "**\n\n```yaml\n" + std::string(wrong.yaml) + "```\n```text\n" +
         std::string(wrong.messages) + "\n```\n";
}

class WrongSweepFiles : public testing::TestWithParam<WrongSweepFile> {};

TEST_P(WrongSweepFiles, AreRefusedWithEveryProblemInPlace) {
  EXPECT_EQ(refusal(std::string(GetParam().yaml)), GetParam().messages);
}

TEST_P(WrongSweepFiles, AreShownInTheDocumentation) {
  EXPECT_THAT(contents(LAMPREY_SOURCE_DIR "/docs/formats/sweep_file.md"), HasSubstr(documented(GetParam())));
}

std::string test_name(const testing::TestParamInfo<WrongSweepFile>& info) {
  std::string name;
  bool word_begins = true;
  for (const char letter : info.param.title) {
    const bool is_letter = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
    if (is_letter) name += word_begins && letter >= 'a' ? static_cast<char>(letter - 'a' + 'A') : letter;
    word_begins = !is_letter;
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(SweepFile, WrongSweepFiles, testing::ValuesIn(wrong_sweep_files()), test_name);

TEST(SweepFile, IsReadIntoASpecificationWithPositions) {
  const SweepFile file = parse_sweep(R"(name: walk-2006
description: A first look
seed: 18446744073709551615
base: {gait: "walk", acceptance: annealing, temperature: 1}
grids:
  - mutation: [all, one]
    cycles: {from: 100, to: 300, step: 100}
    steps: normal
replicates: 3
)",
                                     "sweep.yaml");
  const auto& specification = file.specification;
  EXPECT_EQ(specification.name(), "walk-2006");
  EXPECT_EQ(specification.description(), "A first look");
  EXPECT_EQ(specification.seed(), 18446744073709551615U);
  EXPECT_EQ(specification.replicates(), 3U);
  ASSERT_EQ(specification.base_size(), 3);
  EXPECT_EQ(specification.base(0).value().text(), "walk");
  EXPECT_EQ(specification.base(2).value().real(), 1.0) << "a whole number serves a real parameter";
  ASSERT_EQ(specification.grids_size(), 1);
  const auto& axes = specification.grids(0).axes();
  ASSERT_EQ(axes.size(), 3);
  EXPECT_EQ(axes[0].parameter(), "mutation");
  EXPECT_EQ(axes[0].values(1).text(), "one");
  EXPECT_EQ(axes[1].range().step().integer(), 100);
  EXPECT_EQ(axes[2].values(0).text(), "normal");
  const auto position = [&](const std::string& field) {
    const auto& found = file.positions.at(field);
    return std::pair(found.line, found.column);
  };
  EXPECT_EQ(position("name"), std::pair(1, 7));
  EXPECT_EQ(position("base.gait"), std::pair(4, 14));
  EXPECT_EQ(position("grids[0]"), std::pair(6, 5));
  EXPECT_EQ(position("grids[0].mutation"), std::pair(6, 5));
  EXPECT_EQ(position("grids[0].mutation[1]"), std::pair(6, 21));
  EXPECT_EQ(position("grids[0].cycles.step"), std::pair(7, 40));
  EXPECT_EQ(position("grids[0].steps[0]"), std::pair(8, 12));
}

TEST(SweepFile, OfTheDocumentationHasAsManyJobsAsItSays) {
  const std::string document = contents(LAMPREY_SOURCE_DIR "/docs/formats/sweep_file.md");
  const std::string fence = "```yaml\n";
  const auto begin = document.find(fence) + fence.size();
  const std::string example = document.substr(begin, document.find("```", begin) - begin);
  EXPECT_EQ(SweepGrid(parse_sweep(example, "sweep_file.md").specification).jobs(), 200U);
}

TEST(SweepFile, IsValidWhereTheDocumentationShowsHowToWriteOne) {
  const std::string document = contents(LAMPREY_SOURCE_DIR "/docs/formats/sweep_file.md");
  const std::string examples = document.substr(0, document.find("## Error messages"));
  const std::string fence = "```yaml\n";
  int files = 0;
  for (auto begin = examples.find(fence); begin != std::string::npos; begin = examples.find(fence, begin + 1)) {
    const auto start = begin + fence.size();
    std::string example = examples.substr(start, examples.find("```", start) - start);
    if (example.starts_with("grids:")) example = "name: a\nbase: {objective: maximise, cycles: 3000}\n" + example;
    if (!example.starts_with("name:")) continue;
    EXPECT_NO_THROW(SweepGrid(parse_sweep(example, "sweep_file.md").specification)) << example;
    ++files;
  }
  EXPECT_EQ(files, 6);
}

TEST(SweepFile, SaysHowItIsRunWithoutBecomingAnotherSweep) {
  const std::string plain = "name: a\nbase: {cycles: 9}\n";
  const auto file = parse_sweep(plain +
                                    "priority: -5\nmax_concurrent: 64\ntime_limit: 0.5\nattempts: 100\n"
                                    "fail_fast: true\nstop_when: {highest_total: 340.5, failed: 10}\n"
                                    "needs: [gpu=1, 'site:lab']\ntags: draft\n",
                                "sweep.yaml");
  const auto& execution = file.specification.execution();
  EXPECT_EQ(execution.priority(), -5);
  EXPECT_EQ(execution.max_concurrent(), 64U);
  EXPECT_EQ(execution.time_limit(), 0.5);
  EXPECT_EQ(execution.attempts(), 100U);
  EXPECT_TRUE(execution.fail_fast());
  ASSERT_EQ(execution.stop_when_size(), 2);
  EXPECT_EQ(execution.stop_when(0).measure(), "highest_total");
  EXPECT_EQ(execution.stop_when(0).at_least(), 340.5);
  EXPECT_EQ(execution.stop_when(1).at_least(), 10);
  ASSERT_EQ(execution.needs_size(), 2);
  EXPECT_EQ(execution.needs(1), "site:lab");
  ASSERT_EQ(execution.tags_size(), 1);
  EXPECT_EQ(execution.tags(0), "draft");
  const auto position = file.positions.at("needs[1]");
  EXPECT_EQ(std::pair(position.line, position.column), std::pair(9, 16));

  const auto without = parse_sweep(plain, "sweep.yaml").specification;
  EXPECT_FALSE(without.has_execution());
  EXPECT_EQ(sweep_id(file.specification), sweep_id(without));
}

// The documentation's first example has a grid of its own for the exception.
TEST(SweepFile, HasTheSameJobsWithAWhereAsWithAGridForTheException) {
  const std::string head = "name: a\nbase: {cycles: 9}\ngrids:\n";
  const SweepGrid plain(
      parse_sweep(head + "  - {mutation: [all, one], steps: [uniform, normal], mutation_size: [25, 50]}\n"
                         "  - {mutation: [all, one], steps: one_fifth_rule}\n",
                  "a")
          .specification);
  const SweepGrid composed(parse_sweep(head +
                                           "  - {mutation: [all, one], steps: [uniform, normal, one_fifth_rule],"
                                           " mutation_size: {values: [25, 50], where: {steps: [uniform, normal]}}}\n",
                                       "a")
                               .specification);
  ASSERT_EQ(plain.jobs(), 10U);
  ASSERT_EQ(composed.jobs(), 10U);
  for (std::uint64_t number = 0; number < 10; ++number) {
    EXPECT_EQ(identity(plain.job(number)), identity(composed.job(number))) << number;
  }
}

TEST(SweepFile, TurnsChangesOfTheEnvironmentIntoASettingOfTheBase) {
  const auto file = parse_sweep(
      "name: a\nenvironment:\n  - {push_factor: 0.50, at: 5, required_distance: 25}\n"
      "  - {at: 9, ground_level_back_left: 12}\nbase: {objective: maximise}\n",
      "a");
  const auto parameters = SweepGrid(file.specification).job(0).parameters;
  EXPECT_EQ(parameters.choice("environment"), "5 required_distance=25 push_factor=0.5; 9 ground_level_back_left=12");
  const auto written = parse_sweep(
      "name: a\nbase:\n  environment: 5 required_distance=25 push_factor=0.5; 9 ground_level_back_left=12\n"
      "  objective: maximise\n",
      "a");
  EXPECT_EQ(sweep_id(file.specification), sweep_id(written.specification));
}

TEST(SweepFile, HasDefaultsForSeedAndReplicates) {
  const auto specification = parse_sweep("name: a\n", "sweep.yaml").specification;
  EXPECT_EQ(specification.seed(), 1U);
  EXPECT_EQ(specification.replicates(), 1U);
}

TEST(SweepFile, TakesRealNumbersHoweverTheyAreWritten) {
  const auto value = [](const std::string& text) {
    const SweepGrid grid(
        parse_sweep("name: a\nbase: {acceptance: annealing, temperature: " + text + "}\n", "a").specification);
    return grid.job(0).parameters.real("temperature");
  };
  EXPECT_EQ(value("1"), 1.0);
  EXPECT_EQ(value("0.1"), 0.1);
  EXPECT_EQ(value("1e3"), 1000.0);
  EXPECT_EQ(value("2.50"), 2.5);
}

TEST(SweepFile, MayBeginWithAByteOrderMarkAndEndLinesInCrLf) {
  const auto specification = parse_sweep("\xEF\xBB\xBFname: a\r\nseed: 5\r\nbase: {gait: walk}\r\n", "a").specification;
  EXPECT_EQ(specification.name(), "a");
  EXPECT_EQ(specification.seed(), 5U);
}

TEST(SweepFile, IsRefusedIfEmpty) {
  EXPECT_THAT(refusal(""), HasSubstr("a sweep file is a mapping of name, base, grids and so on; this is nothing"));
  EXPECT_THAT(refusal("# only a comment\n"), HasSubstr("this is nothing"));
}

TEST(SweepFile, IsRefusedIfItIsNotUtf8OrHasControlCharacters) {
  EXPECT_EQ(refusal("name: a\ndescription: x\xFF\n"),
            "sweep.yaml:2:15: '\\xff' is not text in UTF-8, or is a control character");
  // The YAML parser takes this byte for the end of the file: what follows would be ignored in silence.
  EXPECT_EQ(refusal("name: a\n\x04replicates: 7\n"),
            "sweep.yaml:2:1: '\\x04' is not text in UTF-8, or is a control character");
  EXPECT_THAT(refusal(std::string("n\0a\0m\0e\0", 8)), HasSubstr("sweep.yaml:1:2: '\\x00' is not text"));
  EXPECT_THAT(refusal("name: a\ndescription: \"\\e[31m\"\n"), HasSubstr("sweep.yaml:2:14: description: '\\x1b[31m'"));
}

TEST(SweepFile, IsRefusedIfTooLarge) {
  EXPECT_EQ(refusal(std::string(maximum_yaml_bytes + 1, '#')), "sweep.yaml: the file is larger than 1048576 bytes");
  EXPECT_EQ(refusal("name: a\n" + std::string(maximum_yaml_bytes - 8, '#')), "no refusal");
}

TEST(SweepFile, IsRefusedIfItHasTooManyNodes) {
  std::string yaml = "name: a\nbase: {gait: [";
  for (int i = 0; i < 100'000; ++i) yaml += "1,";
  EXPECT_THAT(refusal(yaml + "]}\n"), EndsWith("more than 100000 values in one file; use ranges"));
}

TEST(SweepFile, IsRefusedAtOnceIfNestedWithoutEnd) {
  EXPECT_THAT(refusal("name: a\nbase: " + std::string(500'000, '[')), EndsWith("nested more than 8 deep"));
  EXPECT_THAT(refusal("name: a\nbase: " + std::string(500'000, '{')), EndsWith("nested more than 8 deep"));
  std::string dashes = "name: a\nbase:\n";
  for (int i = 0; i < 10'000; ++i) dashes += "- ";
  EXPECT_THAT(refusal(dashes), EndsWith("nested more than 8 deep"));
}

TEST(SweepFile, IsToldAboutAHundredProblemsAtMost) {
  std::string yaml = "name: a\n";
  for (int i = 0; i < 1000; ++i) yaml += "name: b\n";
  const std::string text = refusal(yaml);
  EXPECT_EQ(std::ranges::count(text, '\n'), 99);
  std::string unknown = "name: a\n";
  for (int i = 0; i < 1000; ++i) unknown += "unknown" + std::to_string(i) + ": b\n";
  EXPECT_EQ(std::ranges::count(refusal(unknown), '\n'), 99);
}

TEST(SweepFile, ProblemsCarryFieldFileLineAndColumn) {
  try {
    parse_sweep("name: a\ngrids:\n  - steps: [unifrom]\n", "dir/b.yaml");
    FAIL();
  } catch (const InvalidInput& error) {
    ASSERT_EQ(error.problems().size(), 1U);
    const Problem& problem = error.problems().front();
    EXPECT_EQ(problem.field, "grids[0].steps[0]");
    EXPECT_EQ(problem.file, "dir/b.yaml");
    EXPECT_EQ(problem.line, 3);
    EXPECT_EQ(problem.column, 13);
    EXPECT_THAT(problem.message, EndsWith("did you mean 'uniform'?"));
  }
}

TEST(ReadSweepFile, SaysWhyAFileCannotBeRead) {
  const auto refused = [](const std::string& path) -> std::string {
    try {
      read_sweep_file(path);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "no refusal";
  };
  EXPECT_EQ(refused("no/such.yaml"), "no/such.yaml: no such file");
  EXPECT_EQ(refused("/"), "/: is a directory");
  EXPECT_EQ(refused("/dev/zero"), "/dev/zero: the file is larger than 1048576 bytes");
}

}  // namespace
}  // namespace lamprey::experiment
