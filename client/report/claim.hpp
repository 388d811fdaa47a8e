#pragma once

#include "client/evidence.hpp"
#include "client/statistics/intervals.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The thesis's claims held against measured results.
namespace lamprey::client::report {

enum class Verdict : unsigned char { holds, does_not_hold, not_run };

/// "holds", "does not hold", "not run".
std::string_view to_text(Verdict verdict);

/// One number with what is known of it, and what it says.
struct Measured {
  std::string judged_on;  ///< column of `result` or name of a measure: "evolved_total", "success_rate"
  std::optional<statistics::Interval> interval;
  Verdict verdict = Verdict::not_run;
};

/// A part of a claim: one comparison. A claim holds if all its decisive parts do.
struct Part {
  std::string name;         ///< "all, simple: normal - uniform"
  std::string expectation;  ///< what the thesis leads to expect of the number, short: "above 0"
  std::string rule;         ///< how it is judged, a sentence; shared by parts of a kind
  std::string unit;
  bool decisive = true;  ///< else it is shown beside, and judges nothing
  std::string sql;       ///< the query behind it
  std::vector<Measured> measured;
};

/// Sweeps that together hold what a claim rests on.
struct Family {
  std::vector<std::string> sweeps;
  /// Asks how far verdicts depend on the reading of the thesis: shown as a table of verdicts only.
  bool interpretations = false;
};

/// One row per claim (design of the findings; docs/guides/findings.md). A claim is assessed per reading found.
struct Claim {
  int number;
  std::string_view statement;
  std::string_view thesis;  ///< what it says there, and where
  std::vector<Family> families;
  std::vector<std::string> told_apart_by;   ///< columns of `result` that make readings
  std::vector<std::string> needs;           ///< other columns of `result` that its queries use
  bool needs_measures = false;              ///< and the view `measure`
  std::vector<std::string_view> judged_on;  ///< a verdict for each of these
  std::vector<std::string_view> figures;    ///< of `lamprey plot`, for the HTML report
  std::vector<Part> (*assess)(const Evidence& evidence, const Reading& reading) = nullptr;
};

/// In the order of their numbers.
std::span<const Claim> claim_table();

/// How many decisive comparisons say what.
struct Tally {
  std::size_t hold = 0;
  std::size_t do_not_hold = 0;
  std::size_t not_run = 0;

  std::size_t all() const { return hold + do_not_hold + not_run; }
};

/// Of the comparisons that verdict_on goes by.
Tally tally_on(const Claim& claim, const std::vector<Part>& parts, std::string_view judged_on);

/// The claim's verdict on `judged_on`: of its decisive parts those judged on it, and those judged on no column of the
/// claim's list (a success rate). One that doesn't hold decides; else one that is not run.
Verdict verdict_on(const Claim& claim, const std::vector<Part>& parts, std::string_view judged_on);

}  // namespace lamprey::client::report
