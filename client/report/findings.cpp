#include "client/report/findings.hpp"

#include "client/output/formatting.hpp"
#include "client/report/judgement.hpp"

#include <algorithm>

namespace lamprey::client::report {

namespace {

std::vector<std::string> present_sweeps(const Evidence& evidence, const Family& family) {
  std::vector<std::string> present;
  std::ranges::copy_if(family.sweeps, std::back_inserter(present),
                       [&](const auto& sweep) { return evidence.has_sweep(sweep); });
  return present;
}

/// Whether another family has the very same jobs: all of chapter 8 in one sweep, or its three parts.
bool others_stand_in(const Evidence& evidence, const Family& family) {
  const std::string& first = family.sweeps.front();
  const bool whole = evidence.has_sweep("thesis-chapter-8");
  const bool parts =
      evidence.has_sweep("mutate-all") || evidence.has_sweep("mutate-one") || evidence.has_sweep("mutate-some");
  return (first == "mutate-all" && (whole || !parts)) || (first == "thesis-chapter-8" && !whole && parts);
}

/// Which columns the claim's queries need and the database, made by an older Lamprey, has not.
std::vector<std::string> missing_columns(const Evidence& evidence, const Claim& claim) {
  std::vector<std::string> missing;
  for (const auto& column : claim.needs) {
    if (!evidence.has_column("result", column)) missing.push_back("result." + column);
  }
  if (claim.needs_measures && !evidence.has_column("measure", "value")) missing.emplace_back("measure.value");
  return missing;
}

Finding assess(const Evidence& evidence, const Claim& claim) {
  Finding finding{.claim = &claim, .assessments = {}, .missing_sweeps = {}, .why_not_run = {}};
  const auto columns = missing_columns(evidence, claim);
  for (const auto& family : claim.families) {
    const auto sweeps = present_sweeps(evidence, family);
    if (others_stand_in(evidence, family)) continue;
    for (const auto& sweep : family.sweeps) {
      if (std::ranges::find(sweeps, sweep) == sweeps.end()) finding.missing_sweeps.push_back(sweep);
    }
    if (sweeps.empty() || !columns.empty()) continue;
    for (auto& reading : evidence.readings(sweeps, claim.told_apart_by)) {
      auto parts = claim.assess(evidence, reading);
      finding.assessments.push_back({std::move(reading), family.interpretations, std::move(parts)});
    }
  }
  const bool there = std::ranges::any_of(claim.families,
                                         [&](const auto& family) { return !present_sweeps(evidence, family).empty(); });
  if (!there) {
    finding.why_not_run = "None of its sweeps is in the database.";
  } else if (!columns.empty()) {
    finding.why_not_run = "The database has no " + output::joined(columns, ", ") +
                          ": an older Lamprey made it. Run the sweeps with this one.";
  } else if (finding.assessments.empty()) {
    finding.why_not_run = "No job of its sweeps is done yet.";
  }
  return finding;
}

}  // namespace

Findings assess_claims(const Evidence& evidence, const std::function<void(int)>& progress) {
  Findings all{
      .database = evidence.path(), .science_version = evidence.science_version(), .sweeps = {}, .findings = {}};
  std::vector<std::string> used;
  for (const auto& claim : claim_table()) {
    progress(claim.number);
    all.findings.push_back(assess(evidence, claim));
    for (const auto& assessment : all.findings.back().assessments) {
      for (const auto& sweep : assessment.reading.sweeps) {
        if (std::ranges::find(used, sweep) == used.end()) used.push_back(sweep);
      }
    }
  }
  for (const auto& name : used) {
    const auto sweep = std::ranges::find_if(evidence.sweeps(), [&](const auto& row) { return row.what.name == name; });
    all.sweeps.push_back({name, storage::to_text(sweep->state), sweep->counts.done, sweep->what.jobs});
  }
  return all;
}

std::string run_command(const std::string& sweep) {
  return "lamprey run sweeps/" + sweep + ".yaml";
}

std::string title_of(const Reading& reading) {
  const auto values = reading.text();
  return output::joined(reading.sweeps, ", ") + (values.empty() ? "" : ": ") + values;
}

std::string in_words(std::string_view column) {
  std::string words(column);
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::vector<std::string> differences(const Assessment& assessment) {
  std::vector<std::string> sentences;
  for (const auto& part : assessment.parts) {
    if (!part.decisive) continue;
    std::vector<std::string> numbers;
    for (const auto& measured : part.measured) {
      if (measured.verdict != Verdict::does_not_hold) continue;
      numbers.push_back(figure(measured.interval) + (part.unit.empty() ? "" : " " + part.unit) + " (" +
                        in_words(measured.judged_on) + ")");
    }
    if (numbers.empty()) continue;
    sentences.push_back(part.name + " is " + output::joined(numbers, " and ") + "; the thesis has it " +
                        part.expectation + ".");
  }
  return sentences;
}

}  // namespace lamprey::client::report
