#include "client/output/formatting.hpp"
#include "client/report/judgement.hpp"
#include "client/report/render.hpp"

#include <algorithm>

namespace lamprey::client::report {

namespace {

const char* const style = R"(
body { font: 16px/1.5 system-ui, sans-serif; color: #1c2430; background: #fff; max-width: 68rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2.6rem; border-top: 1px solid #dde3ea; padding-top: 1.2rem; } h3 { font-size: 1rem; margin-bottom: .3rem; }
table { border-collapse: collapse; margin: .6rem 0 1rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: .25rem .8rem .25rem 0; border-bottom: 1px solid #e6ebf0; vertical-align: top; }
th { font-weight: 600; border-bottom-color: #9aa7b5; }
.holds { color: #00634a; } .differs { color: #a33f00; } .open { color: #6b7684; }
.verdict { font-weight: 600; white-space: nowrap; }
.thesis, .note { color: #4a5563; } ul { padding-left: 1.2rem; }
pre { background: #f4f6f9; padding: .7rem .9rem; overflow-x: auto; font-size: .82rem; line-height: 1.35; } code { font-size: .9em; }
summary { cursor: pointer; color: #2b5d8c; }
.beside td { color: #6b7684; } .pictures svg { max-width: 100%; height: auto; }
)";

std::string escaped(std::string_view text) {
  std::string result;
  for (const char character : text) {
    switch (character) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += character;
    }
  }
  return result;
}

std::string element(const std::string& name, const std::string& content, const std::string& css_class = "") {
  return "<" + name + (css_class.empty() ? "" : " class=\"" + css_class + "\"") + ">" + content + "</" + name + ">";
}

std::string verdict_html(Verdict verdict) {
  const char* css_class = verdict == Verdict::holds ? "holds" : verdict == Verdict::does_not_hold ? "differs" : "open";
  const char* sign = verdict == Verdict::holds ? "✓ " : verdict == Verdict::does_not_hold ? "✗ " : "";
  return element("span", sign + std::string(to_text(verdict)), std::string("verdict ") + css_class);
}

std::string row_html(const std::vector<std::string>& cells, const std::string& cell = "td",
                     const std::string& css_class = "") {
  std::string content;
  for (const auto& text : cells) content += element(cell, text);
  return element("tr", content, css_class) + "\n";
}

std::string held_html(const Claim& claim, const Assessment& assessment, std::string_view column) {
  const auto tally = tally_on(claim, assessment.parts, column);
  return std::to_string(tally.hold) + " of " + std::to_string(tally.all());
}

std::string summary_html(const Findings& findings, bool interpretations) {
  std::string rows = row_html({"claim", "", "reading", "judged on", "verdict", "comparisons that hold"}, "th");
  bool any = false;
  for (const auto& finding : findings.findings) {
    const auto& claim = *finding.claim;
    const auto number =
        "<a href=\"#claim-" + std::to_string(claim.number) + "\">" + std::to_string(claim.number) + "</a>";
    bool first = true;
    for (const auto& assessment : finding.assessments) {
      if (assessment.interpretation != interpretations) continue;
      bool first_column = true;
      for (const auto column : claim.judged_on) {
        const bool leads = std::exchange(first, false);
        rows += row_html({leads ? number : "", leads ? escaped(claim.statement) : "",
                          std::exchange(first_column, false) ? escaped(title_of(assessment.reading)) : "",
                          escaped(in_words(column)), verdict_html(verdict_on(claim, assessment.parts, column)),
                          held_html(claim, assessment, column)});
        any = true;
      }
    }
    if (finding.assessments.empty() && !interpretations) {
      rows += row_html({number, escaped(claim.statement), "", "", verdict_html(Verdict::not_run), ""});
      any = true;
    }
  }
  return any ? element("table", rows) + "\n" : "";
}

std::string measured_html(const Part& part, const Measured& measured) {
  if (!measured.interval) return element("span", "not run", "open");
  return escaped(figure(measured.interval) + (part.unit.empty() ? "" : " " + part.unit)) + " " +
         (part.decisive ? verdict_html(measured.verdict) : "") +
         element("span", " n&nbsp;=&nbsp;" + output::with_thousands(measured.interval->size), "note");
}

std::string parts_html(const Claim& claim, const Assessment& assessment) {
  std::vector<std::string> titles = {"comparison", "thesis"};
  for (const auto column : claim.judged_on) titles.push_back(escaped(in_words(column)));
  std::string rows = row_html(titles, "th");
  for (const auto& part : assessment.parts) {
    std::vector<std::string> cells(titles.size());
    cells[0] = escaped(part.name);
    cells[1] = escaped(part.expectation);
    if (part.measured.empty()) cells[2] = element("span", "not run", "open");
    for (const auto& measured : part.measured) {
      const auto found = std::ranges::find(claim.judged_on, measured.judged_on);
      const auto position = found == claim.judged_on.end() ? 0 : found - claim.judged_on.begin();
      cells[static_cast<std::size_t>(position) + 2] = measured_html(part, measured);
    }
    rows += row_html(cells, "td", part.decisive ? "" : "beside");
  }
  return element("table", rows) + "\n";
}

std::string list_html(const std::vector<std::string>& items) {
  std::string content;
  for (const auto& item : items) content += element("li", escaped(item)) + "\n";
  return element("ul", content) + "\n";
}

std::string sql_html(const Assessment& assessment) {
  std::vector<std::string> queries;
  for (const auto& part : assessment.parts) {
    if (std::ranges::find(queries, part.sql) == queries.end()) queries.push_back(part.sql);
  }
  std::string content = "<summary>SQL</summary>";
  for (const auto& query : queries) content += element("pre", escaped(query + ";"));
  return element("details", content) + "\n";
}

std::string assessment_html(const Claim& claim, const Assessment& assessment) {
  std::string html = element("h3", escaped(title_of(assessment.reading))) + "\n";
  std::string verdicts;
  for (const auto column : claim.judged_on) {
    verdicts += (verdicts.empty() ? "" : ", ") + ("on the " + escaped(in_words(column))) + ": " +
                verdict_html(verdict_on(claim, assessment.parts, column));
  }
  html += element("p", verdicts) + "\n" + parts_html(claim, assessment);
  const auto sentences = differences(assessment);
  if (!sentences.empty()) html += element("p", "Differs from the thesis:") + "\n" + list_html(sentences);
  return html + sql_html(assessment);
}

std::string finding_html(const Finding& finding, const std::vector<std::string>& pictures) {
  const auto& claim = *finding.claim;
  const std::string number = std::to_string(claim.number);
  std::string html = "<h2 id=\"claim-" + number + "\">" + number + ". " + escaped(claim.statement) + "</h2>\n" +
                     element("p", "Thesis: " + escaped(claim.thesis), "thesis") + "\n";
  if (finding.assessments.empty()) {
    html += element("p", verdict_html(Verdict::not_run) + ". " + escaped(finding.why_not_run)) + "\n";
    std::string commands;
    for (const auto& sweep : finding.missing_sweeps) commands += run_command(sweep) + "\n";
    return html + element("pre", escaped(commands));
  }
  std::vector<std::string> rules;
  for (const auto& assessment : finding.assessments) {
    for (const auto& part : assessment.parts) {
      if (std::ranges::find(rules, part.rule) == rules.end()) rules.push_back(part.rule);
    }
  }
  html += list_html(rules);
  for (const auto& assessment : finding.assessments) {
    if (!assessment.interpretation) html += assessment_html(claim, assessment);
  }
  std::string images;
  for (const auto& picture : pictures) images += picture + "\n";
  return html + (images.empty() ? "" : "<div class=\"pictures\">\n" + images + "</div>\n");
}

std::string sweeps_html(const Findings& findings) {
  std::string rows = row_html({"sweep", "state", "jobs done"}, "th");
  for (const auto& sweep : findings.sweeps) {
    rows += row_html({escaped(sweep.name), escaped(sweep.state),
                      output::with_thousands(sweep.done) + " of " + output::with_thousands(sweep.jobs)});
  }
  return findings.sweeps.empty() ? "" : element("table", rows) + "\n";
}

}  // namespace

std::string as_html(const Findings& findings, const Pictures& pictures) {
  std::string body = element("h1", "What the thesis claims, and what was measured") + "\n" +
                     element("p", "Database " + element("code", escaped(findings.database)) + ", science version " +
                                      std::to_string(findings.science_version) + ".") +
                     "\n" + sweeps_html(findings) + summary_html(findings, false);
  const auto interpretations = summary_html(findings, true);
  if (!interpretations.empty())
    body += element("h2", "How far the verdicts depend on the reading of the thesis") + "\n" + interpretations;
  for (std::size_t i = 0; i < findings.findings.size(); ++i) {
    const auto found = pictures.find(i);
    body += finding_html(findings.findings[i], found == pictures.end() ? std::vector<std::string>{} : found->second);
  }
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<title>Findings</title>\n<style>" +
         std::string(style) + "</style>\n</head>\n<body>\n" + body + "</body>\n</html>\n";
}

}  // namespace lamprey::client::report
