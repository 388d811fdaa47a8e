#include "client/watch_state.hpp"

#include "client/output/formatting.hpp"
#include "client/output/progress.hpp"
#include "client/sweep_watch.hpp"
#include "client/views/events.hpp"
#include "client/views/sweeps.hpp"
#include "client/views/workers.hpp"

#include <algorithm>
#include <sstream>

namespace lamprey::client {

namespace {

/// The same place to write to, but into memory.
output::Console into(std::ostream& stream, const output::Console& console) {
  return {.out = stream,
          .err = console.err,
          .out_is_terminal = console.out_is_terminal,
          .err_is_terminal = console.err_is_terminal,
          .colour = console.colour,
          .unicode = console.unicode,
          .columns = console.columns,
          .rows = console.rows};
}

/// What a line of progress is written for: rates and times change all the time.
std::string telling(const idl::SweepStatus& sweep) {
  return sweep.state() + sweep.counts().SerializeAsString() + std::to_string(sweep.divergences());
}

}  // namespace

void WatchState::take(const idl::StatusReply& status) {
  status_ = status;
  has_status_ = true;
}

bool WatchState::take(const messaging::SweepProgress& progress) {
  const std::string id = experiment::to_hex(progress.sweep);
  const auto found =
      std::ranges::find_if(*status_.mutable_sweeps(), [&](const auto& sweep) { return sweep.id() == id; });
  if (found == status_.mutable_sweeps()->end()) return false;
  found->set_state(progress.state);
  auto& counts = *found->mutable_counts();
  counts.set_jobs(progress.jobs);
  counts.set_pending(progress.pending);
  counts.set_leased(progress.leased);
  counts.set_done(progress.done);
  counts.set_failed(progress.failed);
  counts.set_quarantined(progress.quarantined);
  counts.set_cancelled(progress.cancelled);
  found->set_divergences(progress.divergences);
  found->set_jobs_per_second(progress.jobs_per_second);
  if (progress.seconds_left >= 0) {
    found->set_seconds_left(progress.seconds_left);
  } else {
    found->clear_seconds_left();
  }
  return true;
}

void WatchState::take(const idl::EventsReply& events) {
  for (const auto& event : events.events()) {
    if (event.event() <= newest_event_) continue;
    newest_event_ = event.event();
    events_.push_back(event);
    if (events_.size() > most_events) events_.pop_front();
    if (has_events_) untold_.push_back(event);
  }
  has_events_ = true;
}

std::string WatchState::frame(const output::Console& console, const std::string& note, std::size_t rows) const {
  std::ostringstream text;
  const auto inner = into(text, console);
  text << console.bold("Lamprey") << "  " << output::without_controls(status_.database()) << "  "
       << console.dim("epoch " + std::to_string(status_.epoch()));
  if (!note.empty()) text << "  " << console.alert(note);
  text << '\n';
  if (!status_.storage_fault().empty()) {
    text << console.alert("STORAGE FAULT: nothing can be stored: ") << output::without_controls(status_.storage_fault())
         << '\n';
  }
  text << '\n';
  // Headings, rules and blank lines, and the events, have their place; sweeps and workers share the rest.
  const std::size_t taken = 10 + events_.size();
  const std::size_t each = std::max<std::size_t>((rows - std::min(rows, taken)) / 2, 2);
  const auto sweeps = views::shown_sweeps(status_, status_.sweeps_size() == 1);
  if (sweeps.empty()) {
    text << "No sweeps yet: lamprey submit FILE\n";
  } else {
    views::print_sweep_bars(inner, sweeps, each);
  }
  text << '\n';
  // Each has a line of what it is computing.
  views::print_workers_in_detail(inner, status_, std::max<std::size_t>(each / 2, 1));
  if (!events_.empty()) text << '\n';
  for (const auto& event : events_) text << views::event_line(console, event) << '\n';
  return text.str();
}

Json WatchState::json() const {
  Json json = document("watch");
  json["database"] = status_.database();
  json["epoch"] = status_.epoch();
  json["storage_fault"] = status_.storage_fault().empty() ? Json(nullptr) : Json(status_.storage_fault());
  json["sweeps"] = Json::array();
  for (const auto& sweep : status_.sweeps()) json["sweeps"].push_back(views::sweep_json(sweep, status_.workers_size()));
  json["workers"] = views::workers_json(status_);
  json["events"] = Json::array();
  for (const auto& event : events_) json["events"].push_back(views::event_json(event));
  return json;
}

std::vector<std::string> WatchState::new_lines(const output::Console& console, std::int64_t unix_milliseconds) {
  std::vector<std::string> lines;
  for (const auto& event : untold_) lines.push_back(views::event_line(console, event));
  untold_.clear();
  if (const auto& fault = status_.storage_fault(); told_[""] != fault) {
    told_[""] = fault;
    lines.push_back(fault.empty() ? views::event_line(console, unix_milliseconds, "storage_works", "")
                                  : views::event_line(console, unix_milliseconds, "storage_fault", fault));
  }
  for (const auto* sweep : views::shown_sweeps(status_, status_.sweeps_size() == 1)) {
    auto& told = told_[sweep->id()];
    if (auto now = telling(*sweep); now != told) {
      told = std::move(now);
      lines.push_back(views::event_line(console, unix_milliseconds, "progress",
                                        output::progress_line(progress_of(*sweep, status_.workers_size()))));
    }
  }
  return lines;
}

}  // namespace lamprey::client
