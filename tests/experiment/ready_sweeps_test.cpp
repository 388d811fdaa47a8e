#include "experiment/schedule.hpp"
#include "experiment/sweep.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <set>

// The sweep files that ship with the project.

namespace lamprey::experiment {
namespace {

SweepGrid ready_sweep(const std::string& name) {
  return SweepGrid(read_sweep_file(LAMPREY_SOURCE_DIR "/sweeps/" + name + ".yaml").specification);
}

TEST(ReadySweeps, AreAllValidNamedAsTheirFilesAndSayWhatTheyAre) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(LAMPREY_SOURCE_DIR "/sweeps")) {
    SCOPED_TRACE(entry.path());
    ASSERT_EQ(entry.path().extension(), ".yaml");
    const auto specification = read_sweep_file(entry.path()).specification;
    EXPECT_EQ(specification.name(), entry.path().stem());
    EXPECT_FALSE(specification.description().empty());
    std::ifstream file(entry.path());
    std::string what;
    std::string source;
    std::getline(file, what);
    std::getline(file, source);
    EXPECT_TRUE(what.starts_with("# What: ") && what.ends_with(".")) << what;
    EXPECT_TRUE(source.starts_with("# Source: ") && source.ends_with(".")) << source;
    names.insert(specification.name());
  }
  for (const auto* name :
       {"appendix-b",      "biped-networks",  "changing-conditions", "chapter-8-carry", "chapter-8-carry-total",
        "chapter-8-total", "figure-6-25",     "figure-6-27",         "figure-6-30",     "figure-7-17",
        "figure-7-22",     "figure-9-4",      "figure-9-5",          "figure-9-6",      "gait-change-weights",
        "gaits",           "interpretations", "mutate-all",          "mutate-one",      "mutate-some",
        "quickstart",      "terrain",         "thesis-chapter-8",    "trainers"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

/// Every number of jobs that the heads of the files promise, such as 41,472 jobs.
TEST(ReadySweeps, HaveAsManyJobsAsTheirHeadsSay) {
  for (const auto& entry : std::filesystem::directory_iterator(LAMPREY_SOURCE_DIR "/sweeps")) {
    SCOPED_TRACE(entry.path());
    std::ifstream file(entry.path());
    std::string what;
    std::getline(file, what);
    const auto end = what.find(" jobs");
    ASSERT_NE(end, std::string::npos);
    std::string number = what.substr(what.rfind(' ', end - 1) + 1);
    number.resize(number.find(' '));
    std::erase(number, ',');
    EXPECT_EQ(std::to_string(SweepGrid(read_sweep_file(entry.path()).specification).jobs()), number);
  }
}

TEST(ReadySweeps, HaveAsManyJobsAsTheThesissTable) {
  EXPECT_EQ(ready_sweep("mutate-all").jobs(), 18'432U);
  EXPECT_EQ(ready_sweep("mutate-one").jobs(), 18'432U);
  EXPECT_EQ(ready_sweep("mutate-some").jobs(), 4'608U);
  EXPECT_EQ(ready_sweep("thesis-chapter-8").jobs(), 41'472U);
}

TEST(ReadySweeps, QuickstartCoversEveryOperator) {
  const SweepGrid grid = ready_sweep("quickstart");
  EXPECT_EQ(grid.jobs(), 360U);
  std::set<std::array<std::string, 3>> operators;
  for (std::uint64_t number = 0; number < grid.jobs(); ++number) {
    const Parameters parameters = grid.job(number).parameters;
    operators.insert({parameters.choice("mutation"), parameters.choice("steps"), parameters.choice("acceptance")});
    EXPECT_EQ(parameters.integer("cycles"), 1000);
  }
  EXPECT_EQ(operators.size(), 3U * 3U * 2U);
}

TEST(ReadySweeps, ChapterEightHasEachExperimentOnce) {
  const SweepGrid grid = ready_sweep("thesis-chapter-8");
  std::set<std::string> cells;
  for (std::uint64_t number = 0; number < grid.jobs(); ++number) {
    EXPECT_TRUE(cells.insert(canonical_text(grid.job(number).parameters)).second) << number;
  }
  EXPECT_EQ(cells.size(), 41'472U);
}

TEST(ReadySweeps, CellsOfTheOneMutationSweepsAreTheSameJobsInChapterEight) {
  const SweepGrid chapter = ready_sweep("thesis-chapter-8");
  std::map<std::string, std::uint64_t> numbers;
  for (std::uint64_t number = 0; number < chapter.jobs(); ++number) {
    numbers.emplace(canonical_text(chapter.job(number).parameters), number);
  }
  std::uint64_t found = 0;
  for (const auto* name : {"mutate-all", "mutate-one", "mutate-some"}) {
    const SweepGrid grid = ready_sweep(name);
    for (std::uint64_t number = 0; number < grid.jobs(); ++number) {
      const Job job = grid.job(number);
      const auto same = numbers.find(canonical_text(job.parameters));
      ASSERT_NE(same, numbers.end()) << name << " " << number;
      ASSERT_EQ(identity(job), identity(chapter.job(same->second))) << name << " " << number;
      ++found;
    }
  }
  EXPECT_EQ(found, chapter.jobs());
}

/// The parameters in which the first jobs of two sweeps of equally many differ.
std::set<std::string> differences(const SweepGrid& a, const SweepGrid& b) {
  EXPECT_EQ(a.jobs(), b.jobs());
  std::set<std::string> names;
  for (std::uint64_t number = 0; number < a.jobs(); number += 97) {
    const auto first = a.job(number).parameters;
    const auto second = b.job(number).parameters;
    for (std::size_t row = 0; row < registry().size(); ++row) {
      if (first[row] != second[row]) names.insert(std::string(registry()[row].name));
    }
  }
  return names;
}

TEST(ReadySweeps, OfOtherReadingsDifferFromChapterEightInThatOnly) {
  const SweepGrid chapter = ready_sweep("thesis-chapter-8");
  using Names = std::set<std::string>;
  EXPECT_EQ(differences(chapter, ready_sweep("appendix-b")), Names({"cycles"}));
  EXPECT_EQ(differences(chapter, ready_sweep("chapter-8-carry")), Names({"posture"}));
  EXPECT_EQ(differences(chapter, ready_sweep("chapter-8-total")), Names({"criterion"}));
  EXPECT_EQ(differences(chapter, ready_sweep("chapter-8-carry-total")), Names({"criterion", "posture"}));
}

TEST(ReadySweeps, ForTheBipedHaveTheThesissEvaluations) {
  // 6.2.2.4: 100 generations of 40 members, each simulated for 40 time steps.
  const auto parameters = ready_sweep("figure-6-25").job(0).parameters;
  EXPECT_EQ(parameters.integer("cycles"), 100 * 40);
  EXPECT_EQ(parameters.integer("time_steps"), 40);
  // 6.2.2.5: 12.5 % and then 12.5 % more in each experiment.
  std::set<double> rates;
  const SweepGrid rate_sweep = ready_sweep("figure-6-27");
  for (std::uint64_t number = 0; number < rate_sweep.cells(); ++number) {
    rates.insert(rate_sweep.job(number).parameters.real("mutation_rate"));
  }
  EXPECT_EQ(rates, std::set<double>({12.5, 25, 37.5, 50, 62.5, 75, 87.5, 100}));
}

TEST(ReadySweeps, OfGaitsHaveEachNetworksGaitsOnce) {
  std::map<std::string, std::set<std::string>> gaits;
  const SweepGrid grid = ready_sweep("gaits");
  for (std::uint64_t number = 0; number < grid.jobs(); ++number) {
    const auto parameters = grid.job(number).parameters;
    EXPECT_TRUE(gaits[parameters.choice("network")].insert(parameters.choice("gait")).second) << number;
  }
  const std::set<std::string> all = {"walk", "trot", "pace", "gallop", "pronk"};
  auto with_frames = all;
  with_frames.insert("walk_frames");
  EXPECT_EQ(gaits["four_mother"], all);
  EXPECT_EQ(gaits["timed_loop"], all);
  EXPECT_EQ(gaits["one_mother"], with_frames);
  EXPECT_EQ(gaits["recurrent_eight"], std::set<std::string>({"walk", "walk_frames"}));
  EXPECT_EQ(gaits["split_generator"], std::set<std::string>({"trot", "pace", "gallop", "pronk"}));
  EXPECT_EQ(gaits["tonic"], std::set<std::string>({"walk", "trot", "pace", "gallop"}));
}

TEST(ReadySweeps, OfChangingConditionsChangeThreeTimesForEveryCombinationOfOperators) {
  const SweepGrid grid = ready_sweep("changing-conditions");
  std::set<std::array<std::string, 4>> operators;
  for (std::uint64_t number = 0; number < grid.jobs(); ++number) {
    const auto parameters = grid.job(number).parameters;
    ASSERT_EQ(parse_schedule(parameters.choice("environment")).size(), 3U);
    ASSERT_TRUE(parameters.applies(parameter_index("environment")));
    operators.insert({parameters.choice("mutation"), parameters.choice("steps"), parameters.choice("acceptance"),
                      parameters.choice("criterion")});
  }
  EXPECT_EQ(operators.size(), 3U * 3U * 2U * 2U);
}

TEST(ReadySweeps, OfTrainersGiveEachTheSameNumberOfEvaluations) {
  const SweepGrid grid = ready_sweep("trainers");
  std::map<std::string, std::set<std::string>> networks;
  for (std::uint64_t number = 0; number < grid.jobs(); ++number) {
    const auto parameters = grid.job(number).parameters;
    EXPECT_EQ(parameters.integer("cycles"), 4000);
    networks[parameters.choice("trainer")].insert(parameters.choice("network"));
  }
  EXPECT_EQ(networks.size(), find_parameter("trainer")->choices.size());
  for (const auto& [trainer, tried] : networks) EXPECT_EQ(tried.size(), 3U) << trainer;
}

}  // namespace
}  // namespace lamprey::experiment
