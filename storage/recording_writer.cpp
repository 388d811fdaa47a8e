#include "storage/recording_writer.hpp"

namespace lamprey::storage {

namespace {

/// More memory than this isn't kept for the next try.
constexpr std::size_t kept_text_bytes = 1 << 20;

std::optional<std::string_view> unless_empty(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional<std::string_view>(text);
}

}  // namespace

RecordingWriter::RecordingWriter(const Connection& connection)
    : connection_(connection),
      // The same attempt comes again until its worker has an answer, then perhaps as one that is not accepted (?11).
      insert_recording_(
          connection,
          "INSERT INTO recording (sweep, job, number, at, worker, robot, token, state, accepted, checksum) "
          "SELECT ?1, ?2, 1 + coalesce(max(number), 0), ?3, ?4, ?5, ?6, ?7, ?8, ?9 FROM recording "
          "WHERE sweep = ?1 AND job = ?2 "
          "HAVING EXISTS (SELECT 1 FROM sweep WHERE sweep = ?1 AND state <> 'deleting') "
          "AND NOT coalesce(max(checksum IN (?9, ?10)), 0) AND (?8 OR count(*) FILTER (WHERE accepted = 0) < ?11) "
          "RETURNING recording"),
      insert_evaluation_(connection,
                         "INSERT INTO robot_evaluation (recording, evaluation, attempt, voided, measured, steps, "
                         "commanded, reported, feet) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)") {}

TryRow RecordingWriter::row_of(const RobotTry& tried) {
  write_whole_numbers(tried.commanded, texts_[0]);
  write_whole_numbers(tried.reported, texts_[1]);
  write_whole_numbers(tried.feet_down, texts_[2]);
  return {.evaluation = tried.evaluation,
          .attempt = tried.attempt,
          .voided = unless_empty(tried.voided),
          .measured = tried.measured,
          .steps = tried.time_steps(),
          .commanded = texts_[0],
          .reported = texts_[1],
          .feet = texts_[2]};
}

void RecordingWriter::write(const RecordedAttempt& attempt, std::int64_t now) {
  const auto& recording = attempt.recording;
  if (const auto fault = recording_fault(recording); !fault.empty()) {
    throw StorageError(StorageError::Kind::input_output,
                       connection_.path() + ": sweep " + std::to_string(attempt.sweep) + ", job " +
                           std::to_string(attempt.job) + ": a recording is not in order: " + fault);
  }
  RecordingRow row{.sweep = attempt.sweep,
                   .job = attempt.job,
                   .worker = attempt.worker == 0 ? std::nullopt : std::optional(attempt.worker),
                   .robot = recording.robot,
                   .token = recording.token,
                   .state = to_text(attempt.state),
                   .accepted = attempt.accepted};
  RecordingChecksum checksum;
  for (const auto& tried : recording.tries) checksum.add(row_of(tried));
  const auto own = checksum.of(row);
  row.accepted = !row.accepted;
  const auto other = checksum.of(row);
  insert_recording_.with(row.sweep, row.job, now, row.worker, std::string_view(row.robot), row.token,
                         std::string_view(row.state), attempt.accepted, std::span<const std::uint8_t>(own),
                         std::span<const std::uint8_t>(other), most_other_recordings);
  const bool is_new = insert_recording_.step();
  const std::int64_t key = is_new ? insert_recording_.integer(0) : 0;
  insert_recording_.run();
  if (!is_new) return;
  for (const auto& tried : recording.tries) {
    const TryRow of_try = row_of(tried);
    insert_evaluation_
        .with(key, of_try.evaluation, of_try.attempt, of_try.voided, of_try.measured, of_try.steps, of_try.commanded,
              of_try.reported, of_try.feet)
        .run();
  }
  for (auto& text : texts_) {
    if (text.capacity() > kept_text_bytes) std::string().swap(text);
  }
}

}  // namespace lamprey::storage
