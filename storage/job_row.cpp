#include "storage/job_row.hpp"

#include "storage/schema.hpp"
#include "storage/trace_text.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace lamprey::storage {

namespace {

/// cycles_run, accepted, successes, success_rate, trace, measures.
constexpr int outcome_columns_after_scores = 6;

/// Reads columns one after the other and notes what has the wrong type or value.
class RowReader {
 public:
  RowReader(const Statement& row, std::vector<Malformed>& malformed) : row_(row), malformed_(malformed) {}

  std::string_view text() {
    require(SQLITE_TEXT, "text");
    return row_.text(column_++);
  }

  std::uint64_t whole(std::uint64_t maximum = std::numeric_limits<std::uint64_t>::max()) {
    require(SQLITE_INTEGER, "a whole number");
    const auto value = row_.bits(column_);
    if (value > maximum) note("the stored " + std::to_string(row_.integer(column_)) + " is out of range");
    ++column_;
    return value > maximum ? 0 : value;
  }

  std::uint32_t whole_32() { return static_cast<std::uint32_t>(whole(std::numeric_limits<std::uint32_t>::max())); }

  double real() {
    require(SQLITE_FLOAT, "a real number");
    const double value = row_.real(column_);
    if (!std::isfinite(value)) note("the stored number is not finite");
    ++column_;
    return value;
  }

  std::optional<experiment::Digest> digest() {
    auto digest = row_.digest(column_);
    if (!digest) note("the stored value is not a blob of 32 bytes");
    ++column_;
    return digest;
  }

  /// The text, without passing over it.
  std::string_view peek_text() const { return row_.text(column_); }
  void skip() { ++column_; }

  /// Whether the column holds NULL; if so, it is passed over.
  bool null() {
    const bool is_null = row_.is_null(column_);
    if (is_null) ++column_;
    return is_null;
  }

  /// Passes over columns that must all be NULL.
  void nulls(int count, const char* fault = "a value is stored although the job is not done") {
    for (; count > 0; --count, ++column_) {
      if (!row_.is_null(column_)) note(fault);
    }
  }

  void note(std::string text) { malformed_.push_back({std::string(row_.name(column_)), std::move(text)}); }

 private:
  void require(int type, const char* name) {
    if (row_.type(column_) != type) note(std::string("the stored value is not ") + name);
  }

  const Statement& row_;
  std::vector<Malformed>& malformed_;
  int column_ = 0;
};

experiment::Outcome read_outcome(RowReader& reader) {
  experiment::Outcome outcome;
  for (const auto& score : job_scores()) {
    for (const auto& part : score_parts()) outcome.*score.member.*part.member = reader.real();
  }
  outcome.cycles = reader.whole_32();
  outcome.accepted = reader.whole_32();
  outcome.successes = reader.whole_32();
  outcome.success_rate = reader.real();
  return outcome;
}

/// A column of JSON that has exactly one text for each value: what is read from it, written again, must give it back.
template <typename Rows, typename Write>
void read_json_column(RowReader& reader, const std::optional<std::vector<Rows>>& rows, const Write& write,
                      std::vector<Rows>& to) {
  if (!rows) return reader.note("the stored text is not a list of its rows");
  std::string canonical;
  write(*rows, canonical);
  if (canonical != reader.peek_text()) return reader.note("the stored text is not in canonical form");
  to = *rows;
}

void read_trace_column(RowReader& reader, experiment::Outcome& outcome) {
  read_json_column(reader, read_trace(reader.peek_text()), write_trace, outcome.trace);
  reader.skip();
}

void read_measures_column(RowReader& reader, experiment::Outcome& outcome) {
  if (reader.null()) return;
  read_json_column(reader, read_measures(reader.peek_text()), write_measures, outcome.measures);
  if (reader.peek_text() == "[]") reader.note("an empty list is stored instead of nothing");
  reader.skip();
}

double read_seconds(RowReader& reader) {
  return reader.null() ? 0 : reader.real();
}

/// Both columns hold a number, or neither does.
std::optional<EndedJob::Source> read_source(RowReader& reader, JobState state) {
  if (reader.null()) {
    reader.nulls(1, "a value is stored although no sweep is");
    return std::nullopt;
  }
  if (state != JobState::done) reader.note("a value is stored although the job is not done");
  EndedJob::Source source;
  source.sweep = static_cast<std::int64_t>(reader.whole());
  source.job = reader.whole();
  return source;
}

}  // namespace

std::optional<JobState> job_state(std::string_view text) {
  for (const auto state : {JobState::done, JobState::failed, JobState::quarantined, JobState::cancelled}) {
    if (to_text(state) == text) return state;
  }
  return std::nullopt;
}

const std::vector<JobScore>& job_scores() {
  using experiment::Outcome;
  static const std::vector<JobScore> scores = {
      {"expected", "of the undisturbed gait", &Outcome::expected},
      {"initial", "after the disturbance, before the first mutation", &Outcome::initial},
      {"evolved", "of the accepted state nearest to the expected fitness", &Outcome::evolved},
      {"highest", "of the accepted state with the highest total", &Outcome::highest},
      {"final", "of the last accepted state", &Outcome::final}};
  return scores;
}

const std::vector<ScorePart>& score_parts() {
  using experiment::Score;
  static const std::vector<ScorePart> parts = {{"stability", "Stability (eq. 7.5)", &Score::stability},
                                               {"distance", "Distance (eq. 7.7)", &Score::distance},
                                               {"fuel", "Fuel (eq. 7.9)", &Score::fuel},
                                               {"total", "Weighted total (eq. 7.4)", &Score::total}};
  return parts;
}

std::string job_columns(int version) {
  std::string list =
      "sweep, job, state, identity, digest, attempt, worker, seconds, reason, seed, replicate, parameters";
  for (const auto& score : job_scores()) {
    for (const auto& part : score_parts()) list += ", " + score.prefix + "_" + part.name;
  }
  list += ", cycles_run, accepted, successes, success_rate, trace";
  list += version < first_version_with_measures ? ", NULL AS measures" : ", measures";
  for (const auto& column : columns_since_version_3("job")) {
    list += (version < first_version_with_execution ? ", NULL AS " : ", ") + column.name;
  }
  return list;
}

StoredJobRow read_job_row(const Statement& row) {
  StoredJobRow stored;
  EndedJob& job = stored.job;
  RowReader reader(row, stored.malformed);
  job.sweep = static_cast<std::int64_t>(reader.whole());
  job.job = reader.whole();
  const auto state = job_state(row.text(2));
  if (!state) reader.note("the stored text is not a state");
  job.state = state.value_or(JobState::failed);
  static_cast<void>(reader.text());
  if (!reader.null()) job.identity = reader.digest();
  if (!reader.null()) job.digest = reader.digest();
  job.attempt = reader.whole_32();
  if (!reader.null()) job.worker = reader.whole();
  job.seconds = reader.real();
  if (!reader.null()) job.reason = reader.text();
  if (!reader.null()) job.seed = reader.whole();
  if (!reader.null()) job.replicate = reader.whole_32();
  if (!reader.null()) job.parameters = reader.text();
  const int scores = static_cast<int>(job_scores().size() * score_parts().size());
  if (job.state == JobState::done) {
    job.outcome = read_outcome(reader);
    read_trace_column(reader, *job.outcome);
    read_measures_column(reader, *job.outcome);
  } else {
    reader.nulls(scores + outcome_columns_after_scores);
  }
  job.queue_seconds = read_seconds(reader);
  job.waited_seconds = read_seconds(reader);
  job.commit_seconds = read_seconds(reader);
  job.reused_from = read_source(reader, job.state);
  return stored;
}

}  // namespace lamprey::storage
