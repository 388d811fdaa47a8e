#include "experiment/execution_validation.hpp"

#include "experiment/sweep_validation.hpp"
#include "experiment/typed_value.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace lamprey::experiment {

namespace {

constexpr std::array<std::string_view, 3> counts = {"failed", "done", "divergences"};
constexpr std::string_view rate = "success_rate";

bool is_count(std::string_view measure) {
  return std::ranges::find(counts, measure) != counts.end();
}

std::string whole_number(std::int64_t minimum, std::int64_t maximum) {
  return "a whole number from " + std::to_string(minimum) + " to " + std::to_string(maximum);
}

std::string out_of_range(const std::string& value, std::string_view field, const std::string& takes) {
  return value + " is out of range: " + std::string(field) + " takes " + takes;
}

void check_stop_condition(const idl::StopCondition& condition, std::set<std::string>& seen, Findings& findings) {
  const auto& measure = condition.measure();
  const std::string path = axis_path("stop_when", measure);
  const auto& known = stop_measures();
  if (std::ranges::find(known, measure) == known.end()) {
    const std::string nearest = nearest_name(measure, known);
    const std::string hint = nearest.empty() ? "; a measure is failed, done, divergences, success_rate, or a score of "
                                               "the view result such as highest_total"
                                             : "; did you mean '" + nearest + "'?";
    return findings.add(path, "unknown measure '" + printable(measure) + "'" + hint);
  }
  if (!seen.insert(measure).second) return findings.add(path, "is given twice; keep one of them");
  const double value = condition.at_least();
  const bool good = is_count(measure)
                        ? value >= 1 && value <= static_cast<double>(maximum_jobs) && value == std::floor(value)
                        : std::isfinite(value) && (measure != rate || (value >= 0 && value <= 1));
  if (!good) findings.add(path, out_of_range(to_text(Value(value)), measure, stop_measure_takes(measure)));
}

void check_labels(const google::protobuf::RepeatedPtrField<std::string>& labels, const std::string& field,
                  std::string_view what, Findings& findings) {
  if (labels.size() > maximum_labels) {
    return findings.add(field, "has " + std::to_string(labels.size()) + " " + std::string(what) + "s; at most " +
                                   std::to_string(maximum_labels) + " are allowed");
  }
  std::set<std::string_view> seen;
  for (int i = 0; i < labels.size(); ++i) {
    const std::string path = value_path(field, static_cast<std::size_t>(i));
    if (const auto fault = label_fault(labels[i], what)) {
      findings.add(path, *fault);
    } else if (!seen.insert(labels[i]).second) {
      findings.add(path, labels[i] + " is in this list twice");
    }
  }
}

}  // namespace

std::string priority_takes() {
  return whole_number(minimum_priority, maximum_priority);
}
std::string max_concurrent_takes() {
  return whole_number(1, maximum_concurrent_jobs);
}
std::string time_limit_takes() {
  return "a number of seconds above 0 and up to " + std::to_string(static_cast<std::int64_t>(maximum_time_limit));
}
std::string attempts_takes() {
  return whole_number(1, maximum_attempts);
}

const std::vector<std::string_view>& stop_measures() {
  // The scores as the view `result` names them.
  static const std::vector<std::string_view> measures = {"failed",
                                                         "done",
                                                         "divergences",
                                                         "success_rate",
                                                         "expected_stability",
                                                         "expected_distance",
                                                         "expected_fuel",
                                                         "expected_total",
                                                         "initial_stability",
                                                         "initial_distance",
                                                         "initial_fuel",
                                                         "initial_total",
                                                         "evolved_stability",
                                                         "evolved_distance",
                                                         "evolved_fuel",
                                                         "evolved_total",
                                                         "highest_stability",
                                                         "highest_distance",
                                                         "highest_fuel",
                                                         "highest_total",
                                                         "final_stability",
                                                         "final_distance",
                                                         "final_fuel",
                                                         "final_total"};
  return measures;
}

std::string stop_measure_takes(std::string_view measure) {
  if (is_count(measure)) return whole_number(1, static_cast<std::int64_t>(maximum_jobs));
  return measure == rate ? "a number from 0 to 1" : "a number";
}

std::optional<std::string> label_fault(std::string_view text, std::string_view what) {
  const bool readable = std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("-_.:=").find(c) != std::string_view::npos;
  });
  if (!text.empty() && readable && text.size() <= maximum_label_length) return std::nullopt;
  return "'" + printable(text) + "' is not allowed: a " + std::string(what) + " has 1 to " +
         std::to_string(maximum_label_length) + " letters, digits, '-', '_', '.', ':' and '='";
}

void check_execution(const idl::Execution& execution, Findings& findings) {
  if (execution.priority() < minimum_priority || execution.priority() > maximum_priority) {
    findings.add("priority", out_of_range(std::to_string(execution.priority()), "priority", priority_takes()));
  }
  if (execution.max_concurrent() > maximum_concurrent_jobs) {
    findings.add("max_concurrent",
                 out_of_range(std::to_string(execution.max_concurrent()), "max_concurrent", max_concurrent_takes()));
  }
  // Not a number fails this too.
  if (!(execution.time_limit() >= 0 && execution.time_limit() <= maximum_time_limit)) {
    findings.add("time_limit", out_of_range(to_text(Value(execution.time_limit())), "time_limit", time_limit_takes()));
  }
  if (execution.attempts() > maximum_attempts) {
    findings.add("attempts", out_of_range(std::to_string(execution.attempts()), "attempts", attempts_takes()));
  }
  std::set<std::string> seen;
  for (const auto& condition : execution.stop_when()) {
    if (findings.full()) return;
    check_stop_condition(condition, seen, findings);
  }
  check_labels(execution.needs(), "needs", "label", findings);
  check_labels(execution.tags(), "tags", "tag", findings);
}

std::vector<Problem> validate(const idl::Execution& execution) {
  Findings findings({});
  check_execution(execution, findings);
  return findings.take();
}

}  // namespace lamprey::experiment
