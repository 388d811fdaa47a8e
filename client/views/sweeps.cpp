#include "client/views/sweeps.hpp"

#include "client/output/bar.hpp"
#include "client/output/formatting.hpp"
#include "client/output/table.hpp"
#include "client/sweep_summary.hpp"
#include "client/sweep_watch.hpp"

#include <algorithm>
#include <functional>

namespace lamprey::client::views {

namespace {

using output::Align;
using output::with_thousands;
using Sweeps = std::vector<const idl::SweepStatus*>;

struct Column {
  output::Table::Column heading;
  std::function<std::string(const idl::SweepStatus&)> cell;
  /// Shown only if a row has something in it.
  bool rare = false;
};

/// Nothing for 0: a rare column is shown where something is to be seen.
std::string unless_zero(std::uint64_t count) {
  return count == 0 ? "" : with_thousands(count);
}

std::string texts(const google::protobuf::RepeatedPtrField<std::string>& items) {
  return output::without_controls(output::joined({items.begin(), items.end()}, ", "));
}

bool goes_on(const idl::SweepStatus& sweep) {
  return !has_ended(sweep.state());
}

std::string state_text(const idl::SweepStatus& sweep) {
  return sweep.state() + (sweep.archived() ? ", archived" : "");
}

std::string rate_text(const idl::SweepStatus& sweep) {
  return sweep.state() == "running" ? output::rate(sweep.jobs_per_second()) : "";
}

std::string left_text(const idl::SweepStatus& sweep) {
  return sweep.state() == "running" && sweep.has_seconds_left() ? output::duration(sweep.seconds_left()) : "";
}

std::string priority_text(const idl::SweepStatus& sweep) {
  return sweep.execution().priority() == 0 ? "" : std::to_string(sweep.execution().priority());
}

template <typename Count>
Column count_column(const char* title, Count count, bool rare) {
  return {{title, Align::right},
          [count, rare](const idl::SweepStatus& sweep) {
            return rare ? unless_zero(count(sweep)) : with_thousands(count(sweep));
          },
          rare};
}

std::vector<Column> columns() {
  using Sweep = const idl::SweepStatus&;
  return {{{"sweep"}, [](Sweep sweep) { return output::without_controls(sweep.name()); }},
          {{"state"}, state_text},
          {{"priority", Align::right}, priority_text, true},
          count_column(
              "jobs", [](Sweep sweep) { return sweep.counts().jobs(); }, false),
          count_column(
              "done", [](Sweep sweep) { return sweep.counts().done(); }, false),
          count_column(
              "reused", [](Sweep sweep) { return sweep.reused(); }, true),
          count_column(
              "audited", [](Sweep sweep) { return sweep.audited(); }, true),
          count_column(
              "failed", [](Sweep sweep) { return sweep.counts().failed(); }, false),
          count_column(
              "quarantined", [](Sweep sweep) { return sweep.counts().quarantined(); }, true),
          count_column(
              "cancelled", [](Sweep sweep) { return sweep.counts().cancelled(); }, true),
          count_column(
              "leased", [](Sweep sweep) { return sweep.counts().leased(); }, false),
          count_column(
              "pending", [](Sweep sweep) { return sweep.counts().pending(); }, false),
          {{"rate", Align::right}, rate_text, true},
          {{"left", Align::right}, left_text, true},
          {{"tags"}, [](Sweep sweep) { return texts(sweep.execution().tags()); }, true}};
}

std::vector<Column> bar_columns(const output::Console& console) {
  using Sweep = const idl::SweepStatus&;
  const auto progress = [&console](Sweep sweep) {
    constexpr std::size_t width = 24;
    const auto& counts = sweep.counts();
    return output::bar(console,
                       {.jobs = counts.jobs(),
                        .good = counts.done(),
                        .bad = counts.failed() + counts.quarantined() + counts.cancelled()},
                       width);
  };
  const auto share = [](Sweep sweep) { return output::percentage(progress_of(sweep, 1)); };
  std::vector<Column> shown = {{{"sweep"}, [](Sweep sweep) { return output::without_controls(sweep.name()); }},
                               {{"state"}, state_text},
                               {{"progress"}, progress},
                               {{"", Align::right}, share}};
  for (auto& column : columns()) {
    const auto& title = column.heading.title;
    if (title != "sweep" && title != "state" && title != "pending" && title != "tags") {
      shown.push_back(std::move(column));
    }
  }
  return shown;
}

output::Table table_of(const Sweeps& sweeps, const std::vector<Column>& all,
                       const std::function<void(output::Table&, const idl::SweepStatus&)>& notes) {
  std::vector<const Column*> shown;
  std::vector<output::Table::Column> headings;
  for (const auto& column : all) {
    const bool tells =
        !column.rare || std::ranges::any_of(sweeps, [&](const auto* s) { return !column.cell(*s).empty(); });
    if (!tells) continue;
    shown.push_back(&column);
    headings.push_back(column.heading);
  }
  output::Table table(std::move(headings));
  for (const auto* sweep : sweeps) {
    std::vector<std::string> cells;
    for (const auto* column : shown) cells.push_back(column->cell(*sweep));
    table.add(std::move(cells));
    notes(table, *sweep);
  }
  return table;
}

void add_warnings(output::Table& table, const idl::SweepStatus& sweep) {
  if (!sweep.reason().empty()) table.note(sweep.state() + ": " + output::without_controls(sweep.reason()));
  if (sweep.divergences() > 0) {
    table.note(output::counted(sweep.divergences(), "result diverges", "results diverge") +
               " from what is stored: see the table divergence");
  }
}

Json conditions_json(const idl::Execution& execution) {
  Json conditions = Json::object();
  for (const auto& condition : execution.stop_when()) conditions[condition.measure()] = condition.at_least();
  return conditions;
}

}  // namespace

Json sweep_json(const idl::SweepStatus& sweep, int workers) {
  Json row = Json::object();
  add_sweep(row, progress_of(sweep, workers));
  row["reused"] = sweep.reused();
  row["audited"] = sweep.audited();
  row["archived"] = sweep.archived();
  row["reason"] = sweep.reason();
  row["jobs_per_second"] = sweep.jobs_per_second();
  row["seconds_left"] = sweep.has_seconds_left() ? Json(sweep.seconds_left()) : Json(nullptr);
  const auto& execution = sweep.execution();
  row["priority"] = execution.priority();
  row["max_concurrent"] = execution.max_concurrent() == 0 ? Json(nullptr) : Json(execution.max_concurrent());
  row["time_limit"] = execution.time_limit() > 0 ? Json(execution.time_limit()) : Json(nullptr);
  row["attempts"] = execution.attempts() == 0 ? Json(nullptr) : Json(execution.attempts());
  row["fail_fast"] = execution.fail_fast();
  row["stop_when"] = conditions_json(execution);
  row["needs"] = std::vector<std::string>(execution.needs().begin(), execution.needs().end());
  row["tags"] = std::vector<std::string>(execution.tags().begin(), execution.tags().end());
  return row;
}

std::string execution_text(const idl::Execution& execution) {
  std::vector<std::string> parts;
  if (execution.max_concurrent() > 0) {
    parts.push_back("at most " + output::counted(execution.max_concurrent(), "job", "jobs") + " at once");
  }
  if (execution.time_limit() > 0) {
    parts.push_back("at most " + output::duration(execution.time_limit()) + " for a job");
  }
  if (execution.attempts() > 0) parts.push_back(output::counted(execution.attempts(), "attempt", "attempts"));
  if (execution.fail_fast()) parts.emplace_back("ends with its first failure");
  for (const auto& condition : execution.stop_when()) {
    parts.push_back("ends when " + condition.measure() + " is " + output::rounded(condition.at_least()) + " or more");
  }
  if (!execution.needs().empty()) parts.push_back("needs " + texts(execution.needs()));
  return output::joined(parts, "; ");
}

void print_sweeps(const output::Console& console, const Sweeps& sweeps, bool details) {
  table_of(sweeps, columns(), [&](output::Table& table, const idl::SweepStatus& sweep) {
    add_warnings(table, sweep);
    if (const auto how = execution_text(sweep.execution()); details && !how.empty()) table.note(how);
  }).print(console);
}

void print_sweep_bars(const output::Console& console, Sweeps sweeps, std::size_t most) {
  std::stable_partition(sweeps.begin(), sweeps.end(), [](const auto* sweep) { return goes_on(*sweep); });
  const std::size_t left_out = sweeps.size() - std::min(sweeps.size(), most);
  sweeps.resize(sweeps.size() - left_out);
  table_of(sweeps, bar_columns(console), add_warnings).print(console);
  if (left_out > 0) console.out << console.dim("and " + output::counted(left_out, "more sweep", "more sweeps")) << '\n';
}

void print_alarms(const output::Console& console, const idl::StatusReply& status) {
  if (status.storage_fault().empty()) return;
  console.err << "lamprey: " << console.red("STORAGE FAULT:")
              << " nothing can be stored: " << output::without_controls(status.storage_fault())
              << ". Workers keep what they have computed; the coordinator tries again." << std::endl;
}

Sweeps shown_sweeps(const idl::StatusReply& status, bool archived_too) {
  Sweeps shown;
  for (const auto& sweep : status.sweeps()) {
    if (archived_too || !sweep.archived()) shown.push_back(&sweep);
  }
  return shown;
}

ExitCode divergent_or_ok(const Sweeps& sweeps) {
  const bool divergent = std::ranges::any_of(sweeps, [](const auto* sweep) { return sweep->divergences() > 0; });
  return divergent ? exit_mismatch : exit_ok;
}

}  // namespace lamprey::client::views
