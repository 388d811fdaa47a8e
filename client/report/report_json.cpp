#include "client/report/render.hpp"

namespace lamprey::client::report {

namespace {

Json json_of(const Reading& reading) {
  Json json = {{"sweeps", reading.sweeps}};
  for (const auto& [column, literal] : reading.values) json[column] = Json::parse(literal, nullptr, false);
  return json;
}

Json json_of(const Measured& measured) {
  Json json = {{"judged_on", measured.judged_on}, {"verdict", to_text(measured.verdict)}};
  const auto& interval = measured.interval;
  json["estimate"] = interval ? Json(interval->estimate) : Json(nullptr);
  json["low"] = interval ? Json(interval->low) : Json(nullptr);
  json["high"] = interval ? Json(interval->high) : Json(nullptr);
  json["confidence"] = interval ? Json(interval->confidence) : Json(nullptr);
  json["n"] = interval ? Json(interval->size) : Json(nullptr);
  return json;
}

Json json_of(const Part& part) {
  Json json = {{"name", part.name},         {"expectation", part.expectation}, {"rule", part.rule}, {"unit", part.unit},
               {"decisive", part.decisive}, {"measured", Json::array()},       {"sql", part.sql}};
  for (const auto& measured : part.measured) json["measured"].push_back(json_of(measured));
  return json;
}

Json json_of(const Claim& claim, const Assessment& assessment) {
  Json json = {{"reading", json_of(assessment.reading)},
               {"interpretation", assessment.interpretation},
               {"verdicts", Json::object()},
               {"tallies", Json::object()},
               {"differs", differences(assessment)},
               {"parts", Json::array()}};
  for (const auto column : claim.judged_on) {
    json["verdicts"][std::string(column)] = to_text(verdict_on(claim, assessment.parts, column));
    const auto tally = tally_on(claim, assessment.parts, column);
    json["tallies"][std::string(column)] = {
        {"hold", tally.hold}, {"do_not_hold", tally.do_not_hold}, {"not_run", tally.not_run}};
  }
  for (const auto& part : assessment.parts) json["parts"].push_back(json_of(part));
  return json;
}

}  // namespace

Json as_json(const Findings& findings) {
  Json json = document("report");
  json["database"] = findings.database;
  json["science_version"] = findings.science_version;
  json["sweeps"] = Json::array();
  for (const auto& sweep : findings.sweeps) {
    json["sweeps"].push_back(
        {{"sweep", sweep.name}, {"state", sweep.state}, {"done", sweep.done}, {"jobs", sweep.jobs}});
  }
  json["claims"] = Json::array();
  for (const auto& finding : findings.findings) {
    const auto& claim = *finding.claim;
    Json row = {{"number", claim.number},
                {"statement", claim.statement},
                {"thesis", claim.thesis},
                {"judged_on", claim.judged_on},
                {"assessments", Json::array()},
                {"not_run", finding.assessments.empty() ? Json(finding.why_not_run) : Json(nullptr)},
                {"run", Json::array()}};
    for (const auto& assessment : finding.assessments) row["assessments"].push_back(json_of(claim, assessment));
    for (const auto& sweep : finding.missing_sweeps) row["run"].push_back(run_command(sweep));
    json["claims"].push_back(std::move(row));
  }
  return json;
}

}  // namespace lamprey::client::report
