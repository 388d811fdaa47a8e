#include "storage/results_reader.hpp"

#include "tests/storage/support.hpp"

#include <gmock/gmock.h>

namespace lamprey::storage::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Kind = StorageError::Kind;

class ResultsReaderTest : public ::testing::Test {
 protected:
  ResultsReaderTest() : store_(path_), row_(store_.add_sweep(sweep_.what).sweep.row) {}

  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
  SweepCase sweep_ = operator_sweep("operators");
  ResultsStore store_;
  std::int64_t row_;
};

TEST_F(ResultsReaderTest, FindsSweepsByNameAndById) {
  const ResultsReader reader(path_);
  EXPECT_EQ(reader.find_sweep("operators")->row, row_);
  EXPECT_EQ(reader.find_sweep(experiment::to_hex(sweep_.what.id))->what.name, "operators");
  EXPECT_FALSE(reader.find_sweep("operator"));
  EXPECT_EQ(reader.database_id(), store_.database_id());
}

TEST_F(ResultsReaderTest, SeesWhatIsCommittedWhileItIsOpen) {
  const ResultsReader reader(path_);
  EXPECT_FALSE(reader.job(row_, 3));
  store_.commit({.jobs = {done_job(sweep_, row_, 3)}});
  EXPECT_TRUE(reader.job(row_, 3));
}

TEST_F(ResultsReaderTest, ResultsArePagedInOrderOfJob) {
  store_.commit({.jobs = {done_job(sweep_, row_, 9), done_job(sweep_, row_, 2), done_job(sweep_, row_, 5)}});
  const ResultsReader reader(path_);
  const auto page = reader.results("operators", 3, 10);
  ASSERT_EQ(page.rows.size(), 2U);
  EXPECT_EQ(page.columns[1], "job");
  EXPECT_EQ(page.rows[0][1], "5");
  EXPECT_EQ(page.rows[1][1], "9");
  EXPECT_EQ(reader.results("operators", 0, 1).rows.size(), 1U);
  EXPECT_EQ(reader.results("others", 0, 10).rows.size(), 0U);
}

TEST_F(ResultsReaderTest, ValuesAreJsonLiterals) {
  const ResultsReader reader(path_);
  const auto row =
      reader.query("SELECT 1, -2.5, 'a\"\n\u00e9', x'00ff', NULL, 0.1, 9e999, 3.0, CAST(x'ff' AS TEXT)").rows[0];
  EXPECT_THAT(row,
              ElementsAre("1", "-2.5", "\"a\\\"\\n\u00e9\"", "\"00ff\"", "null", "0.1", "null", "3", "\"\ufffd\""));
}

TEST_F(ResultsReaderTest, QueriesThatAreNotOneReadingStatementAreRefused) {
  const ResultsReader reader(path_);
  for (const auto* sql :
       {"DELETE FROM sweep", "SELECT 1; SELECT 2", "", "-- nothing", "BEGIN", "DROP VIEW result", "SELECT nothing",
        "ATTACH '/etc/passwd' AS x", "PRAGMA journal_mode = DELETE", "VACUUM", "SELECT 1; nonsense"}) {
    std::string message;
    EXPECT_EQ(error_of([&] { reader.query(sql); }, &message), Kind::input_output) << sql;
    EXPECT_THAT(message, HasSubstr(path_));
  }
  EXPECT_EQ(reader.query("SELECT 1; -- done").rows.size(), 1U);
  EXPECT_EQ(store_.sweeps().size(), 1U);
}

TEST_F(ResultsReaderTest, MalformedRowIsReportedWithItsColumn) {
  store_.commit({.jobs = {done_job(sweep_, row_, 9)}});
  raw_connection(path_).execute("UPDATE job SET trace = '[[1,2]]'");
  const ResultsReader reader(path_);
  std::string message;
  EXPECT_EQ(error_of([&] { reader.job(row_, 9); }, &message), Kind::corrupt);
  EXPECT_THAT(message, HasSubstr("column trace"));
}

}  // namespace
}  // namespace lamprey::storage::testing
