#include "storage/recording_row.hpp"

namespace lamprey::storage {

namespace {

void add_field(std::string& text, std::string_view value) {
  // With its length, so that no two rows have the same text.
  text.append(std::to_string(value.size())).append(":").append(value).append("\n");
}

}  // namespace

void RecordingChecksum::add(const TryRow& row) {
  std::string text = "evaluation " + std::to_string(row.evaluation) + "\nattempt " + std::to_string(row.attempt) +
                     "\nmeasured " + (row.measured ? "1" : "0") + "\nsteps " + std::to_string(row.steps) +
                     (row.voided ? "\nvoid\n" : "\ncounts\n");
  for (const auto field : {row.voided.value_or(""), row.commanded, row.reported, row.feet}) add_field(text, field);
  tries_ += experiment::to_hex(experiment::sha256(std::string_view(text))) + "\n";
}

experiment::Digest RecordingChecksum::of(const RecordingRow& row) const {
  std::string text = "lamprey-recording/1\nsweep " + std::to_string(row.sweep) + "\njob " + std::to_string(row.job) +
                     "\nworker " + (row.worker ? std::to_string(*row.worker) : "none") + "\ntoken " +
                     std::to_string(row.token) + "\nstate " + row.state + "\naccepted " + (row.accepted ? "1" : "0") +
                     "\n";
  add_field(text, row.robot);
  return experiment::sha256(std::string_view(text + tries_));
}

}  // namespace lamprey::storage
