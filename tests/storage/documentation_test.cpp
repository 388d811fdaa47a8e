#include "tests/storage/support.hpp"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <sstream>

namespace lamprey::storage::testing {
namespace {

/// docs/formats/database.md against a small database.
class DocumentationTest : public ::testing::Test {
 protected:
  DocumentationTest() {
    ResultsStore store(path_);
    const auto sweep = operator_sweep("mutate-all");
    const auto row = store.add_sweep(sweep.what).sweep.row;
    Batch batch;
    for (std::uint64_t job = 0; job < sweep.grid.jobs(); ++job) {
      auto outcome = made_up_outcome(job);
      outcome.measures = {{"recovered", 0, 1}, {"recovery_cycles", 0, 33}};
      batch.jobs.push_back(done_job(sweep, row, job, outcome));
    }
    const auto robots = robot_sweep("on-the-robot");
    const auto robots_row = store.add_sweep(robots.what).sweep.row;
    for (std::uint64_t job = 0; job < robots.grid.jobs(); ++job) {
      batch.jobs.push_back(done_job(robots, robots_row, job));
      if (robots.grid.job(job).parameters.choice("robot") != "bridge") continue;
      const auto worker = batch.jobs.back().worker;
      batch.recordings.push_back({robots_row, job, worker, JobState::done, true, made_up_recording(job)});
    }
    store.commit(batch);
  }

  /// The ```sql blocks of the page.
  std::vector<std::string> sql_blocks() const {
    std::vector<std::string> blocks;
    std::istringstream lines(page_);
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
      if (line == "```sql") {
        inside = true;
        blocks.emplace_back();
      } else if (line == "```") {
        inside = false;
      } else if (inside) {
        blocks.back() += line + "\n";
      }
    }
    return blocks;
  }

  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
  std::string page_ = bytes_of(LAMPREY_DATABASE_PAGE);
};

TEST_F(DocumentationTest, EverySampleQueryRuns) {
  const ResultsReader reader(path_);
  const auto blocks = sql_blocks();
  EXPECT_GE(blocks.size(), 8U);
  for (const auto& block : blocks) EXPECT_NO_THROW(reader.query(block)) << block;
}

TEST_F(DocumentationTest, SampleQueriesOnResultsFindRows) {
  const ResultsReader reader(path_);
  constexpr std::array problems = {"failed", "divergence", "attempts", "audits"};
  for (const auto& block : sql_blocks()) {
    const bool about_problems =
        std::ranges::any_of(problems, [&](const char* word) { return block.find(word) != block.npos; });
    if (about_problems) continue;
    EXPECT_GT(reader.query(block).rows.size(), 0U) << block;
  }
}

// A parameter's column is described on the parameters' own page.
TEST_F(DocumentationTest, PagesNameEveryTableViewAndColumn) {
  const ResultsReader reader(path_);
  const std::string pages = page_ + bytes_of(LAMPREY_PARAMETERS_PAGE);
  for (const auto& row : reader.query("SELECT object, \"column\" FROM schema_description").rows) {
    const auto name = row[1] == "\"\"" ? row[0] : row[1];
    EXPECT_NE(pages.find("`" + name.substr(1, name.size() - 2) + "`"), pages.npos) << row[0] << "." << row[1];
  }
}

}  // namespace
}  // namespace lamprey::storage::testing
