#include "client/evidence.hpp"
#include "client/plot/figure.hpp"
#include "client/plot/script.hpp"
#include "tests/client/site.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace lamprey::tests {
namespace {

const char* const operators_sweep =
    "name: thesis-chapter-8\n"
    "seed: 7\n"
    "base: {cycles: 10, mutation: all}\n"
    "grids:\n"
    "  - {steps: [uniform, normal], acceptance: [simple, annealing], equilibrium_disturbance: [50, 100], "
    "mutation_size: "
    "[50, 100]}\n"
    "replicates: 1\n";

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Sets a variable of the environment for as long as it lives.
class ChangedVariable {
 public:
  ChangedVariable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    ::setenv(name, value.c_str(), 1);
  }
  ~ChangedVariable() { ::setenv(name_, before_.c_str(), 1); }
  ChangedVariable(const ChangedVariable&) = delete;
  ChangedVariable& operator=(const ChangedVariable&) = delete;

 private:
  const char* name_;
  std::string before_;
};

class PlotTest : public testing::Test {
 protected:
  Site site;
};

TEST_F(PlotTest, AFigureOfResultsIsDrawnAsSvg) {
  const auto database = site.database(operators_sweep, 16);
  const auto output = site.path("8-3.svg");
  const auto run = site.run({"plot", "8-3", database, "--output", output});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, output + "\n");
  const auto picture = text_of(output);
  EXPECT_NE(picture.find("<svg"), std::string::npos);
  EXPECT_NE(picture.find("uniform, annealing"), std::string::npos);
  EXPECT_NE(picture.find("expected"), std::string::npos);
}

TEST_F(PlotTest, ASurfaceShowsWhatIsExpected) {
  const auto database = site.database(operators_sweep, 16);
  const auto output = site.path("8-6.svg");
  EXPECT_EQ(site.run({"plot", "8-6", database, "--output", output}).exit_code, 0);
  EXPECT_NE(text_of(output).find("expected 223"), std::string::npos) << "the undisturbed walk, all weights 100 %";
}

TEST_F(PlotTest, APngIsOne) {
  const auto output = site.path("trot.png");
  const auto run = site.run({"plot", "side-view", "gait=trot", "--output", output, "--format", "json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.json()["output"], output);
  EXPECT_TRUE(text_of(output).starts_with("\x89PNG"));
}

TEST_F(PlotTest, EveryFigureOfAGaitCanBeDrawnOfEveryRobot) {
  for (const auto& figure : client::plot::figure_table()) {
    if (figure.source != client::plot::Source::recording) continue;
    const std::string name(figure.name);
    EXPECT_EQ(site.run({"plot", name, "--output", site.path("a.svg")}).exit_code, 0) << name;
    if (name.starts_with("7-")) continue;  // of one network each
    const auto biped =
        site.run({"plot", name, "robot=biped", "network=recurrent_pair", "--output", site.path("b.svg")});
    EXPECT_EQ(biped.exit_code, 0) << name << ": " << biped.err;
  }
}

TEST_F(PlotTest, FitnessIsAveragedBetweenAcceptedChanges) {
  const auto database = site.database(operators_sweep, 16);
  const auto output = site.path("fitness.svg");
  const auto run = site.run({"plot", "fitness", database, "--average-by", "acceptance", "--output", output});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(text_of(output).find("acceptance annealing (mean of 8 jobs)"), std::string::npos);
  EXPECT_EQ(site.run({"plot", "fitness", database, "--jobs", "0,3", "--output", output}).exit_code, 0);
  EXPECT_NE(text_of(output).find("job 3"), std::string::npos);
}

TEST_F(PlotTest, AMissingGnuplotIsNamedWithItsPackage) {
  const ChangedVariable path("PATH", site.path("nowhere"));
  const auto run = site.run({"plot", "side-view", "--output", site.path("a.svg"), "--format", "json"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.json()["error"]["code"], "program_missing");
  EXPECT_NE(run.err.find("gnuplot-nox"), std::string::npos) << run.err;
}

TEST_F(PlotTest, WrongRequestsAreExplained) {
  const auto database = site.database(small_sweep, 3);
  const auto fails = [&](std::vector<std::string> arguments, const std::string& because) {
    arguments.insert(arguments.begin(), "plot");
    const auto run = site.run(arguments);
    EXPECT_EQ(run.exit_code, 2) << because;
    EXPECT_NE(run.err.find(because), std::string::npos) << run.err;
  };
  fails({"side-veiw"}, "did you mean 'side-view'?");
  fails({"side-view", "--output", "a.pdf"}, "must end in .svg or .png");
  fails({"side-view", "gait=trott"}, "did you mean 'trot'?");
  fails({"side-view", database}, "from parameters alone");
  fails({"8-3"}, "name its file");
  fails({"8-3", database}, "lamprey run sweeps/thesis-chapter-8.yaml");
  fails({"fitness", database, "stepz=normal"}, "did you mean 'steps'?");
  fails({"fitness", database, "--sweep", "smal"}, "did you mean 'small'?");
}

TEST_F(PlotTest, TheListNamesEveryFigure) {
  const auto json = site.run({"plot", "list", "--format", "json"}).json();
  EXPECT_EQ(json["figures"].size(), client::plot::figure_table().size());
  EXPECT_NE(site.run({"plot", "list"}).out.find("8-10"), std::string::npos);
}

TEST(PlotScriptTest, TextCannotEndItsQuotes) {
  EXPECT_EQ(client::plot::in_quotes("it's\nhere"), "'it''s here'");
}

TEST(PlotScriptTest, NumbersThatAreNoneAreMissingData) {
  EXPECT_EQ(client::plot::data_block("d", {{1, std::nan("")}, {0.5, 2}}), "$d << EOD\n1 NaN\n0.5 2\nEOD\n");
}

}  // namespace
}  // namespace lamprey::tests
