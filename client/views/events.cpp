#include "client/views/events.hpp"

#include "client/output/formatting.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace lamprey::client::views {

namespace {

Json or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

/// People should see at once what has gone wrong.
bool is_trouble(const std::string& kind) {
  static const std::vector<std::string> troubles = {
      "divergence",    "job_quarantined", "storage_fault",  "sweep_stopped",           "audit_failed",
      "worker_lost",   "worker_refused",  "lease_lost",     "newer_epoch_seen",        "robot_fault",
      "robot_stopped", "robot_lost",      "robot_unsteady", "robot_evaluations_voided"};
  return std::ranges::find(troubles, kind) != troubles.end();
}

}  // namespace

Json event_json(const idl::EventsReply::Event& event) {
  return {{"event", event.event()},
          {"at", event.at()},
          {"kind", event.kind()},
          {"sweep", or_null(event.sweep())},
          {"job", event.has_job() ? Json(event.job()) : Json(nullptr)},
          {"worker", or_null(event.worker())},
          {"text", event.text()}};
}

std::string event_line(const output::Console& console, const idl::EventsReply::Event& event) {
  std::vector<std::string> parts;
  if (!event.sweep().empty()) parts.push_back(event.sweep());
  if (event.has_job()) parts.push_back("job " + std::to_string(event.job()));
  if (!event.worker().empty()) parts.push_back("worker " + event.worker());
  // Some events say the name of what they are about in their text.
  std::string_view text = event.text();
  if (text == event.sweep()) text = {};
  if (const auto name = event.sweep() + ": "; !event.sweep().empty() && text.starts_with(name)) {
    text.remove_prefix(name.size());
  }
  if (!text.empty()) parts.emplace_back(text);
  return event_line(console, event.at(), event.kind(), output::joined(parts, "  "));
}

std::string event_line(const output::Console& console, std::int64_t unix_milliseconds, const std::string& kind,
                       const std::string& text) {
  constexpr std::size_t kind_width = 19;
  const std::string name = output::without_controls(kind);
  const std::string padding(kind_width - std::min(kind_width, output::width(name)), ' ');
  std::string line =
      console.dim(output::date_and_time(unix_milliseconds)) + "  " + (is_trouble(kind) ? console.alert(name) : name);
  if (!text.empty()) line += padding + "  " + output::without_controls(text);
  return line;
}

}  // namespace lamprey::client::views
