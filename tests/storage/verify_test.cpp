#include "storage/statement.hpp"
#include "tests/storage/support.hpp"

#include <bit>
#include <gmock/gmock.h>

namespace lamprey::storage::testing {
namespace {

using ::testing::HasSubstr;

/// A small database with jobs in every state, and a divergence. No two numbers differ in one low bit, so that a flip
/// never gives another job's number.
class VerifyTest : public ::testing::Test {
 protected:
  VerifyTest() {
    ResultsStore store(path_);
    sweep_.what.execution = "how";
    const auto row = store.add_sweep(sweep_.what).sweep.row;
    Batch batch;
    batch.workers.push_back({.incarnation = 7, .host = "a", .process = 1, .threads = 2, .build = "b", .dds = "c"});
    auto outcome = made_up_outcome(4, 2);
    outcome.measures = {{"failures", 4, 0.1}, {"recovered", 0, 1}};
    batch.jobs = {done_job(sweep_, row, 4, outcome),
                  done_job(sweep_, row, 8, made_up_outcome(8, 0)),
                  done_job(sweep_, row, 23, made_up_outcome(23, 30)),
                  ended_job(sweep_, row, 17, JobState::failed, "no memory"),
                  ended_job(sweep_, row, 27, JobState::quarantined, "often"),
                  ended_job(sweep_, row, 30, JobState::cancelled)};
    batch.divergences.push_back({.sweep = row, .job = 4, .stored = *batch.jobs[0].digest});
    store.commit(batch);
  }

  std::string findings() const { return text_of(verify(path_)); }

  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
  SweepCase sweep_ = operator_sweep("operators", 2);
};

TEST_F(VerifyTest, FindsNothingInWhatTheStoreWrote) {
  std::uint64_t last = 0;
  const auto verification = verify(path_, [&](std::uint64_t done) { last = done; });
  EXPECT_EQ(text_of(verification), "");
  EXPECT_EQ(verification.jobs, 6U);
  EXPECT_EQ(verification.trace_rows, 32U);
  EXPECT_EQ(last, 6U);
}

TEST_F(VerifyTest, ChecksBesideAWriter) {
  ResultsStore store(path_);
  store.commit({.jobs = {done_job(sweep_, 1, 9)}});
  EXPECT_EQ(findings(), "");
}

TEST_F(VerifyTest, NamesSweepJobColumnAndBothValues) {
  raw_connection(path_).execute("UPDATE job SET seed = 2007 WHERE job = 4");
  const auto verification = verify(path_);
  ASSERT_EQ(verification.discrepancies.size(), 1U);
  const auto& found = verification.discrepancies[0];
  EXPECT_EQ(found.sweep, "operators");
  EXPECT_EQ(found.job, 4U);
  EXPECT_EQ(found.column, "seed");
  EXPECT_EQ(found.text, "stored 2007, expected 2006");
}

/// Changes one value at a time through SQL, verifies, and puts it back.
class FlipTest : public VerifyTest {
 protected:
  FlipTest() : connection_(raw_connection(path_)) { connection_.execute("PRAGMA ignore_check_constraints = ON"); }

  /// Every value of the row that is not NULL, by column, changed in several ways.
  void expect_every_flip_found(const std::string& table, const std::string& where,
                               const std::vector<std::string>& columns) {
    for (const auto& column : columns) {
      Statement read(connection_, "SELECT " + column + " FROM " + table + " WHERE " + where);
      ASSERT_TRUE(read.step());
      const int type = read.type(0);
      const auto integer = read.integer(0);
      const auto real = read.real(0);
      const auto span = read.blob(0);
      const std::string bytes(span.begin(), span.end());
      read.reset();
      place_ = table + "." + column;
      Statement update(connection_, "UPDATE " + table + " SET " + column + " = ? WHERE " + where);
      if (type == SQLITE_INTEGER) {
        for (const int bit : {0, 1, 7, 31, 40, 63}) expect_found(update, integer ^ std::int64_t(1ULL << bit), integer);
      } else if (type == SQLITE_FLOAT) {
        for (const int bit : {0, 1, 30, 51, 52, 62, 63}) {
          expect_found(update, std::bit_cast<double>(std::bit_cast<std::uint64_t>(real) ^ 1ULL << bit), real);
        }
      } else {
        expect_found_in_each_byte(update, bytes, type == SQLITE_TEXT);
      }
      EXPECT_EQ(findings(), "") << place_ << ": the test does not put everything back";
    }
  }

 private:
  void expect_found_in_each_byte(Statement& update, const std::string& bytes, bool is_text) {
    const auto typed = [&](const std::string& value, const auto& action) {
      const auto blob = std::span(reinterpret_cast<const std::uint8_t*>(value.data()), value.size());
      is_text ? action(std::variant<std::string_view, std::span<const std::uint8_t>>(std::string_view(value)))
              : action(std::variant<std::string_view, std::span<const std::uint8_t>>(blob));
    };
    const auto set = [&](const std::string& value) {
      typed(value,
            [&](const auto& either) { std::visit([&](const auto& bound) { update.with(bound).run(); }, either); });
    };
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      std::string flipped = bytes;
      flipped[at] = static_cast<char>(flipped[at] ^ (1 << at % 8));
      set(flipped);
      EXPECT_NE(findings(), "") << place_ << ", byte " << at << ": '" << flipped << "'";
    }
    set(bytes.substr(0, bytes.size() - 1));
    EXPECT_NE(findings(), "") << place_ << " shortened";
    set(bytes + '\0');
    EXPECT_NE(findings(), "") << place_ << " lengthened";
    set(bytes);
  }

  template <typename Value>
  void expect_found(Statement& update, Value changed, Value original) {
    update.with(changed).run();
    EXPECT_NE(findings(), "") << place_ << " = " << changed;
    update.with(original).run();
  }

  Connection connection_;
  std::string place_;
};

std::vector<std::string> outcome_columns() {
  std::vector<std::string> columns;
  for (const std::string score : {"expected", "initial", "evolved", "highest", "final"}) {
    for (const std::string part : {"stability", "distance", "fuel", "total"}) columns.push_back(score + "_" + part);
  }
  columns.insert(columns.end(), {"cycles_run", "accepted", "successes", "success_rate", "trace", "measures"});
  return columns;
}

// Rows by rowid, in the order in which the fixture stores them: the job's number is one of the columns that flip.

TEST_F(FlipTest, AnyFlipInADoneJobIsFound) {
  expect_every_flip_found("job", "rowid = 1",
                          {"state", "identity", "digest", "seed", "replicate", "parameters", "job", "sweep"});
  expect_every_flip_found("job", "rowid = 1", outcome_columns());
}

TEST_F(FlipTest, AnyFlipInAJobOfAnotherReplicateOrWithoutAnOutcomeIsFound) {
  expect_every_flip_found("job", "rowid = 3", {"seed", "replicate", "job"});
  expect_every_flip_found("job", "rowid = 4", {"state", "identity", "seed", "replicate", "parameters", "job"});
  expect_every_flip_found("job", "rowid = 6", {"state"});
}

TEST_F(FlipTest, AnyFlipInASweepIsFound) {
  expect_every_flip_found(
      "sweep", "true",
      {"id", "name", "specification", "source", "seed", "replicates", "jobs", "science_version", "checksum", "state",
       "done", "failed", "quarantined", "cancelled", "divergences", "reused", "audited", "fresh", "execution"});
  expect_every_flip_found("divergence", "true", {"stored", "job"});
}

TEST_F(VerifyTest, EqualNumbersSpelledOtherwiseAreFound) {
  raw_connection(path_).execute("UPDATE job SET trace = replace(trace, '[[3,', '[[03,') WHERE job = 4");
  EXPECT_THAT(findings(), HasSubstr("operators job 4 trace: the stored text is not in canonical form"));
}

TEST_F(VerifyTest, MeasuresThatNoStoreWritesAreFound) {
  const auto expect_found = [&](const std::string& measures, const std::string& what, const std::string& job = "4") {
    raw_connection(path_).execute("UPDATE job SET measures = " + measures + " WHERE job = " + job);
    EXPECT_THAT(findings(), HasSubstr("operators job " + job + " " + what)) << measures;
  };
  expect_found("'[[\"failures\",4,0.10],[\"recovered\",0,1]]'", "measures: the stored text is not in canonical form");
  expect_found("'[[\"failures\",4]]'", "measures: the stored text is not a list");
  expect_found("'[]'", "measures: an empty list is stored instead of nothing");
  expect_found("'[[\"recovered\",0,1],[\"failures\",4,0.1]]'", "measures: the measure failures 4 comes twice or is");
  expect_found("NULL", "digest");
  expect_found("'[[\"a\",0,1]]'", "measures: a value is stored although the job is not done", "17");
}

// A change of the environment starts the scores anew: none of them need be in the trace.
TEST_F(VerifyTest, ScoresAfterAChangeOfTheEnvironmentNeedNotBeInTheTrace) {
  ResultsStore store(path_);
  auto outcome = made_up_outcome(10);
  outcome.expected.total = 300;
  outcome.evolved = outcome.highest = outcome.final = {1, 2, 3, 4};
  outcome.measures = {{"environment_expected_total", 0, 200}, {"environment_expected_total", 1, 300}};
  store.commit({.jobs = {done_job(sweep_, 1, 10, outcome)}});
  EXPECT_EQ(findings(), "");
  outcome.expected.total = 200;
  store.commit({.jobs = {done_job(sweep_, 1, 11, outcome)}});
  EXPECT_EQ(findings(), "operators job 11 expected_total: stored 200, expected 300\n");
}

TEST_F(VerifyTest, MissingAndSurplusRowsAreFound) {
  const auto other = raw_connection(path_);
  other.execute("BEGIN; DELETE FROM job WHERE job = 4");
  other.execute("COMMIT");
  EXPECT_THAT(findings(), HasSubstr("operators done: stored 3, expected 2"));
}

TEST_F(VerifyTest, OutcomeThatContradictsItselfIsFoundAlthoughItsDigestIsRight) {
  ResultsStore store(path_);
  const auto store_outcome = [&](std::uint64_t number, const auto& spoil) {
    auto outcome = made_up_outcome(number);
    spoil(outcome);
    store.commit({.jobs = {done_job(sweep_, 1, number, outcome)}});
  };
  store_outcome(10, [](auto& outcome) { outcome.success_rate = 0.5; });
  store_outcome(11, [](auto& outcome) { outcome.final.total += 1; });
  store_outcome(12, [](auto& outcome) {
    outcome.highest = outcome.initial;
    outcome.trace[0].score.total = 1e6;
  });
  store_outcome(13, [](auto& outcome) { outcome.evolved.fuel += 1; });
  store_outcome(14, [](auto& outcome) { outcome.accepted -= 1; });
  store_outcome(15, [](auto& outcome) { outcome.trace[2].cycle = outcome.trace[1].cycle; });
  store_outcome(16, [](auto& outcome) { outcome.cycles = 20; });
  const auto found = findings();
  for (const char* place : {"job 10 success_rate", "job 11 final_total", "job 12 highest_total", "job 13 evolved_total",
                            "job 14 accepted", "job 15 trace", "job 16 trace"}) {
    EXPECT_THAT(found, HasSubstr(place));
  }
}

TEST_F(VerifyTest, ChangedViewsDescriptionsAndTablesAreFound) {
  const auto expect_found = [&](const std::string& change, const std::string& what) {
    const auto before = bytes_of(path_);
    raw_connection(path_).execute(change);
    EXPECT_THAT(findings(), HasSubstr(what)) << change;
    write_bytes(path_, before);
  };
  expect_found("DROP VIEW figure_8_4; CREATE VIEW figure_8_4 AS SELECT 1", "view");
  expect_found("UPDATE schema_description SET description = 'x' WHERE object = 'job' AND \"column\" = 'seed'", "view");
  expect_found("ALTER TABLE job ADD COLUMN more", "the table job");
  EXPECT_EQ(findings(), "");
}

TEST_F(VerifyTest, FlippedByteOfTheFileIsFoundOrChangesNothingDeterministic) {
  const auto facts = [&] {
    const ResultsReader reader(path_);
    std::string text;
    for (const char* sql :
         {"SELECT sweep, id, name, specification, source, seed, replicates, jobs, science_version, done FROM sweep",
          "SELECT sweep, job, state, identity, digest, seed, replicate, parameters, trace, expected_total, "
          "initial_fuel, evolved_total, highest_distance, final_total, cycles_run, success_rate, measures FROM job "
          "ORDER BY job",
          "SELECT name, sql FROM sqlite_master WHERE sql IS NOT NULL ORDER BY name",
          "SELECT job, evolved_total, mutation FROM result ORDER BY job", "SELECT * FROM trace ORDER BY job, cycle",
          "SELECT * FROM measure ORDER BY job, name, \"index\""}) {
      for (const auto& row : reader.query(sql).rows) {
        for (const auto& value : row) text += value + '\n';
      }
    }
    return text;
  };
  ASSERT_FALSE(std::filesystem::exists(path_ + "-wal"));
  const std::string intact = bytes_of(path_);
  const std::string expected = facts();
  int found = 0;
  constexpr std::size_t stride = 211;  // a prime: every part of a page has its turn
  for (std::size_t at = 0; at < intact.size(); at += stride) {
    std::string damaged = intact;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
    write_bytes(path_, damaged);
    for (const char* suffix : {"-wal", "-shm"}) std::filesystem::remove(path_ + suffix);
    std::string findings_or_error;
    try {
      findings_or_error = findings();
    } catch (const StorageError& error) {
      findings_or_error = error.what();
    }
    if (findings_or_error.empty()) {
      EXPECT_EQ(facts(), expected) << "byte " << at << " was flipped and not found";
    } else {
      ++found;
    }
  }
  EXPECT_GT(found, 20);
}

}  // namespace
}  // namespace lamprey::storage::testing
