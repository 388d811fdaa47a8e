#pragma once

#include "storage/results_store.hpp"
#include "storage/schema.hpp"
#include "storage/statement.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::storage {

/// One of the five scores of an outcome and how its columns are called: expected_stability, expected_distance, …
struct JobScore {
  std::string prefix;
  std::string meaning;
  experiment::Score experiment::Outcome::*member;
};
const std::vector<JobScore>& job_scores();

struct ScorePart {
  std::string name;
  std::string meaning;
  double experiment::Score::*member;
};
const std::vector<ScorePart>& score_parts();

/// Names of the columns of `job`, in order, between commas; of a database of an older version, with NULL for those that
/// it lacks.
std::string job_columns(int version = schema_version);

/// The inverse of to_text(JobState).
std::optional<JobState> job_state(std::string_view text);

/// Something in a row that no ResultsStore would have written.
struct Malformed {
  std::string column;
  std::string text;
};

/// A row of `job` as it is stored. Whatever is malformed is listed and has its default value in `job`.
struct StoredJobRow {
  EndedJob job;
  std::vector<Malformed> malformed;
};

/// Reads the present row of a statement that selects job_columns().
StoredJobRow read_job_row(const Statement& row);

}  // namespace lamprey::storage
