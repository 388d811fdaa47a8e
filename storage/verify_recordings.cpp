#include "storage/recording.hpp"
#include "storage/recording_row.hpp"
#include "storage/results_store.hpp"
#include "storage/verify_parts.hpp"
#include "storage/view_columns.hpp"

#include <limits>

namespace lamprey::storage {

namespace {

/// The number, where the column has one of the range; else a fault in `fault`.
template <typename Number>
Number whole(const Statement& row, int column, std::string& fault) {
  const std::int64_t value = row.integer(column);
  const bool fits = row.type(column) == SQLITE_INTEGER && value >= 0 &&
                    static_cast<std::uint64_t>(value) <= std::numeric_limits<Number>::max();
  if (!fits) fault = std::string(row.name(column)) + " is no number that it may be";
  return fits ? static_cast<Number>(value) : Number{};
}

/// The tries of one recording, and its checksum.
class RecordingCheck {
 public:
  explicit RecordingCheck(const Connection& connection)
      : tries_(connection,
               "SELECT evaluation, attempt, voided, measured, steps, commanded, reported, feet FROM robot_evaluation "
               "WHERE recording = ? ORDER BY evaluation, attempt") {}

  /// What is wrong with the recording of that key, given the rest of its row; empty if nothing is.
  std::string fault(std::int64_t key, const RecordingRow& row, const std::optional<experiment::Digest>& stored) {
    RobotRecording recording{.robot = row.robot, .token = row.token, .tries = {}};
    RecordingChecksum checksum;
    std::string wrong;
    tries_.with(key);
    while (wrong.empty() && tries_.step()) {
      wrong = read_try(recording.tries.emplace_back(), checksum);
      if (!wrong.empty()) wrong = place(recording.tries.back()) + wrong;
    }
    tries_.reset();
    if (wrong.empty()) wrong = recording_fault(recording);
    if (wrong.empty() && checksum.of(row) != stored) wrong = "its checksum is not that of its columns and evaluations";
    return wrong;
  }

 private:
  static std::string place(const RobotTry& tried) {
    return "evaluation " + std::to_string(tried.evaluation) + ", try " + std::to_string(tried.attempt) + ": ";
  }

  std::string read_try(RobotTry& tried, RecordingChecksum& checksum) const {
    std::string fault;
    tried.evaluation = whole<std::uint32_t>(tries_, 0, fault);
    tried.attempt = whole<std::uint32_t>(tries_, 1, fault);
    const auto voided = tries_.is_null(2) ? std::nullopt : std::optional(tries_.text(2));
    tried.voided = voided.value_or("");
    tried.measured = whole<std::uint32_t>(tries_, 3, fault) != 0;
    const auto steps = whole<std::uint64_t>(tries_, 4, fault);
    int column = 5;
    for (auto* list : {&tried.commanded, &tried.reported, &tried.feet_down}) {
      auto numbers = read_whole_numbers(tries_.text(column));
      if (!numbers) return std::string(tries_.name(column)) + " is no list of whole numbers as it is written";
      *list = std::move(*numbers);
      ++column;
    }
    if (!fault.empty()) return fault;
    if (voided && voided->empty()) return "voided is empty";
    if (steps != tried.time_steps()) {
      return "steps: " + stored_and_expected(std::to_string(steps), std::to_string(tried.time_steps()));
    }
    checksum.add({.evaluation = tried.evaluation,
                  .attempt = tried.attempt,
                  .voided = voided,
                  .measured = tried.measured,
                  .steps = steps,
                  .commanded = tries_.text(5),
                  .reported = tries_.text(6),
                  .feet = tries_.text(7)});
    return {};
  }

  Statement tries_;
};

void verify_contents(const Connection& connection, std::vector<Discrepancy>& discrepancies) {
  Statement rows(connection,
                 "SELECT r.recording, s.name, r.sweep, r.job, r.worker, r.robot, r.token, r.state, r.accepted, "
                 "r.checksum, r.number FROM recording AS r JOIN sweep AS s ON s.sweep = r.sweep "
                 "WHERE s.state <> 'deleting' ORDER BY r.sweep, r.job, r.number");
  RecordingCheck check(connection);
  while (rows.step()) {
    const RecordingRow row{.sweep = rows.integer(2),
                           .job = rows.bits(3),
                           .worker = rows.is_null(4) ? std::nullopt : std::optional(rows.bits(4)),
                           .robot = std::string(rows.text(5)),
                           .token = rows.bits(6),
                           .state = std::string(rows.text(7)),
                           .accepted = rows.integer(8) != 0};
    const auto fault = check.fault(rows.integer(0), row, rows.digest(9));
    if (fault.empty()) continue;
    discrepancies.push_back({std::string(rows.text(1)), row.job, "recording",
                             "attempt " + std::to_string(rows.integer(10)) + ": " + fault});
  }
}

}  // namespace

void verify_recordings(const Connection& connection, std::vector<Discrepancy>& discrepancies) {
  // The recordings of a sweep that is being deleted go piece by piece.
  const std::string recordings =
      "FROM recording AS r JOIN sweep AS s ON s.sweep = r.sweep AND s.state <> 'deleting' "
      "LEFT JOIN job AS j ON j.sweep = r.sweep AND j.job = r.job ";
  add_rows(connection,
           "SELECT s.name, r.job, 'the job''s row is not the end of the attempt that it names' " + recordings +
               "WHERE r.accepted <> 0 AND (j.state IS NOT 'done' OR j.worker IS NOT r.worker)",
           "recording.accepted", discrepancies);
  add_rows(connection,
           "SELECT s.name, r.job, 'the job is not on a robot' " + recordings + "WHERE " +
               parameter_column("robot").definition + " NOT" + real_robots(),
           "recording.job", discrepancies);
  add_rows(connection,
           "SELECT s.name, r.job, sum(r.accepted) || ' attempts are the accepted one' " + recordings +
               "GROUP BY r.sweep, r.job HAVING sum(r.accepted) > 1",
           "recording.accepted", discrepancies);
  add_rows(connection,
           "SELECT s.name, r.job, 'the numbers of its attempts are not 1 to ' || count(*) " + recordings +
               "GROUP BY r.sweep, r.job HAVING min(r.number) <> 1 OR max(r.number) <> count(*)",
           "recording.number", discrepancies);
  verify_contents(connection, discrepancies);
}

}  // namespace lamprey::storage
