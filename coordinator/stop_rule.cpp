#include "coordinator/stop_rule.hpp"

#include "storage/job_row.hpp"

#include <array>
#include <cstdio>
#include <optional>
#include <string_view>

namespace lamprey::coordinator {

namespace {

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.15g", value);
  return text.data();
}

/// Of a column of the view `result`; nothing for other names.
std::optional<double> value_of(const experiment::Outcome& outcome, std::string_view column) {
  if (column == "success_rate") return outcome.success_rate;
  for (const auto& score : storage::job_scores()) {
    for (const auto& part : storage::score_parts()) {
      if (score.prefix + "_" + part.name == column) return outcome.*score.member.*part.member;
    }
  }
  return std::nullopt;
}

std::string reached(const idl::StopCondition& condition, double value) {
  if (value < condition.at_least()) return {};
  return condition.measure() + " is " + number(value) + ", at least " + number(condition.at_least());
}

}  // namespace

std::string reason_to_stop(const idl::Execution& execution, const experiment::Outcome& outcome) {
  for (const auto& condition : execution.stop_when()) {
    const auto value = value_of(outcome, condition.measure());
    if (!value) continue;
    if (auto reason = reached(condition, *value); !reason.empty()) return reason;
  }
  return {};
}

std::string reason_to_stop(const idl::Execution& execution, const storage::JobCounts& counts,
                           std::uint64_t divergences) {
  const std::uint64_t failed = counts.failed + counts.quarantined;
  if (execution.fail_fast() && failed > 0) return "a job has failed, and the sweep is to fail fast";
  for (const auto& condition : execution.stop_when()) {
    std::optional<std::uint64_t> count;
    if (condition.measure() == "failed") count = failed;
    if (condition.measure() == "done") count = counts.done;
    if (condition.measure() == "divergences") count = divergences;
    if (!count) continue;
    if (auto reason = reached(condition, static_cast<double>(*count)); !reason.empty()) return reason;
  }
  return {};
}

}  // namespace lamprey::coordinator
