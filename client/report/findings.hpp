#pragma once

#include "client/report/claim.hpp"

#include <functional>
#include <string>
#include <vector>

namespace lamprey::client::report {

/// A claim under one reading.
struct Assessment {
  Reading reading;
  bool interpretation = false;  ///< from a family of interpretations
  std::vector<Part> parts;
};

/// A claim with all that the database says of it.
struct Finding {
  const Claim* claim = nullptr;  ///< a row of claim_table()
  std::vector<Assessment> assessments;
  std::vector<std::string> missing_sweeps;  ///< that it could rest on too
  std::string why_not_run;                  ///< a sentence, where there are no assessments
};

/// A sweep that claims rest on, as far as it is there.
struct SweepState {
  std::string name;
  std::string state;
  std::uint64_t done = 0;
  std::uint64_t jobs = 0;
};

struct Findings {
  std::string database;
  std::uint32_t science_version = 0;
  std::vector<SweepState> sweeps;
  std::vector<Finding> findings;
};

/// Asks the database about every claim; `progress` is told each claim's number before it is assessed.
Findings assess_claims(const Evidence& evidence, const std::function<void(int)>& progress);

/// How to run a sweep.
std::string run_command(const std::string& sweep);

/// "thesis-chapter-8: posture reset, criterion per_component": the sweeps and what tells readings apart.
std::string title_of(const Reading& reading);

/// One sentence per decisive part that does not hold: what was measured against what the thesis leads to expect.
std::vector<std::string> differences(const Assessment& assessment);

/// "evolved total" for "evolved_total".
std::string in_words(std::string_view column);

}  // namespace lamprey::client::report
