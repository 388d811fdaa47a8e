#include "client/output/formatting.hpp"
#include "client/output/results_table.hpp"
#include "client/output/table.hpp"
#include "client/report/judgement.hpp"
#include "client/report/render.hpp"

#include <algorithm>

namespace lamprey::client::report {

namespace {

using output::Console;
using output::Table;

constexpr std::size_t differences_shown = 6;

std::string mark(const Console& console, Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return console.unicode ? "✓" : "+";
    case Verdict::does_not_hold:
      return console.unicode ? "✗" : "x";
    case Verdict::not_run:
      break;
  }
  return console.unicode ? "·" : ".";
}

/// The text with signs that every terminal has.
std::string plain_signs(const Console& console, std::string text) {
  static const std::string sign = "±";
  for (std::size_t at = 0; !console.unicode && (at = text.find(sign, at)) != std::string::npos;)
    text.replace(at, sign.size(), "+-");
  return text;
}

void print_paragraph(const Console& console, const std::string& text, const std::string& first_indent,
                     const std::string& indent) {
  bool first = true;
  for (const auto& line : output::wrap(plain_signs(console, text), console.columns - indent.size())) {
    console.out << (std::exchange(first, false) ? first_indent : indent) << line << '\n';
  }
}

/// "A", "B", ..., "Z", "AA": the names of readings in this text.
std::string key_of(std::size_t number) {
  std::string key(1, static_cast<char>('A' + number % 26));
  return number < 26 ? key : key_of(number / 26 - 1) + key;
}

/// Each reading once, in order of appearance.
std::vector<Reading> distinct_readings(const Findings& findings, bool interpretations) {
  std::vector<Reading> readings;
  for (const auto& finding : findings.findings) {
    for (const auto& assessment : finding.assessments) {
      if (assessment.interpretation == interpretations &&
          std::ranges::find(readings, assessment.reading) == readings.end())
        readings.push_back(assessment.reading);
    }
  }
  return readings;
}

std::string marks(const Console& console, const Finding& finding, const Assessment& assessment) {
  std::vector<std::string> all;
  for (const auto column : finding.claim->judged_on)
    all.push_back(mark(console, verdict_on(*finding.claim, assessment.parts, column)));
  return output::joined(all, " ");
}

/// The same with the number of comparisons that hold where not all do.
std::string tallies(const Console& console, const Finding& finding, const Assessment& assessment) {
  std::vector<std::string> all;
  for (const auto column : finding.claim->judged_on) {
    const auto verdict = verdict_on(*finding.claim, assessment.parts, column);
    const auto tally = tally_on(*finding.claim, assessment.parts, column);
    all.push_back(verdict == Verdict::does_not_hold ? std::to_string(tally.hold) : mark(console, verdict));
  }
  return output::joined(all, " ");
}

const Assessment* under(const Finding& finding, const Reading& reading) {
  const auto found = std::ranges::find(finding.assessments, reading, &Assessment::reading);
  return found == finding.assessments.end() ? nullptr : &*found;
}

void print_sweeps(const Console& console, const Findings& findings) {
  Table table({{"sweep"}, {"state"}, {"jobs done", output::Align::right}});
  for (const auto& sweep : findings.sweeps) {
    table.add(
        {sweep.name, sweep.state, output::with_thousands(sweep.done) + " of " + output::with_thousands(sweep.jobs)});
  }
  if (table.empty()) return;
  table.print(console);
  console.out << '\n';
}

/// Every claim with a mark per reading and column that it is judged on.
void print_summary(const Console& console, const Findings& findings, const std::vector<Reading>& readings) {
  std::vector<Table::Column> columns = {{"claim", output::Align::right}, {""}};
  std::size_t width = 9;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    columns.push_back({key_of(i)});
    width += 3 + 2;
  }
  Table table(columns);
  const std::size_t room = std::max<std::size_t>(console.columns > width ? console.columns - width : 0, 30);
  for (const auto& finding : findings.findings) {
    const auto lines = output::wrap(finding.claim->statement, room);
    std::vector<std::string> cells = {std::to_string(finding.claim->number), lines.front()};
    for (const auto& reading : readings) {
      const auto* assessment = under(finding, reading);
      cells.push_back(assessment == nullptr ? "" : marks(console, finding, *assessment));
    }
    if (finding.assessments.empty()) cells[1] = output::cut("(not run) " + lines.front(), room, console.ellipsis());
    table.add(std::move(cells));
    if (finding.assessments.empty()) continue;
    for (std::size_t i = 1; i < lines.size(); ++i) table.add({"", lines[i]});
  }
  table.print(console);
  console.out << '\n';
  print_paragraph(console,
                  mark(console, Verdict::holds) + " holds, " + mark(console, Verdict::does_not_hold) +
                      " does not hold, " + mark(console, Verdict::not_run) +
                      " not run; claims 1 to 7 on the evolved total, then on the highest total.",
                  "", "");
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const std::string key = key_of(i) + "  ";
    print_paragraph(console, title_of(readings[i]), key, std::string(key.size(), ' '));
  }
}

/// The values that all readings have; they need no telling in each row.
Reading common_values(const std::vector<Reading>& readings) {
  Reading common = readings.front();
  for (const auto& reading : readings) {
    std::erase_if(common.values,
                  [&](const auto& value) { return std::ranges::find(reading.values, value) == reading.values.end(); });
  }
  return common;
}

void print_interpretations(const Console& console, const Findings& findings) {
  const auto readings = distinct_readings(findings, true);
  if (readings.empty()) return;
  const Reading common = common_values(readings);
  console.out << '\n' << console.bold("How far the verdicts depend on the reading of the thesis") << "\n\n";
  std::vector<Table::Column> columns = {{"claim / its comparisons"}};
  std::vector<const Finding*> shown;
  for (const auto& finding : findings.findings) {
    const auto first = std::ranges::find_if(finding.assessments, &Assessment::interpretation);
    if (first == finding.assessments.end()) continue;
    shown.push_back(&finding);
    const auto all = tally_on(*finding.claim, first->parts, finding.claim->judged_on.front()).all();
    columns.push_back({std::to_string(finding.claim->number) + " /" + std::to_string(all)});
  }
  Table table(columns);
  for (const auto& reading : readings) {
    Reading told_apart = reading;
    std::erase_if(told_apart.values,
                  [&](const auto& value) { return std::ranges::find(common.values, value) != common.values.end(); });
    std::vector<std::string> cells;
    for (const auto& [column, literal] : told_apart.values) {
      const bool is_number = column == "temperature";  // 0.1 and 10 say nothing by themselves
      cells.push_back((is_number ? column + " " : "") + output::readable(literal));
    }
    cells = {output::joined(cells, ", ")};
    for (const auto* finding : shown) {
      const auto* assessment = under(*finding, reading);
      cells.push_back(assessment == nullptr ? "" : tallies(console, *finding, *assessment));
    }
    table.add(std::move(cells));
  }
  table.print(console);
  console.out << '\n';
  print_paragraph(console,
                  "How many comparisons of the claim hold, on the evolved total and on the highest; " +
                      mark(console, Verdict::holds) + ": all, and so does the claim. All of " + title_of(common) + ".",
                  "", "");
}

std::string cell_of(const Console& console, const Part& part, const Measured& measured, bool with_unit) {
  const bool has_unit = with_unit && !part.unit.empty() && measured.interval;
  const auto verdict = mark(console, measured.verdict);
  return figure(measured.interval) + (has_unit ? " " + part.unit : "") +
         (part.decisive ? " " + verdict : " (" + verdict + ")");
}

Table parts_table(const Console& console, const Claim& claim, const Assessment& assessment, bool with_units) {
  std::vector<Table::Column> columns = {{"comparison"}, {"thesis"}};
  for (const auto column : claim.judged_on) columns.push_back({in_words(column)});
  Table table(columns);
  for (const auto& part : assessment.parts) {
    std::vector<std::string> cells(columns.size());
    cells[0] = part.name;
    const std::string_view within = "within ";
    cells[1] = plain_signs(console, part.expectation.substr(part.expectation.starts_with(within) ? within.size() : 0));
    if (part.measured.empty()) cells[2] = "not run";
    for (const auto& measured : part.measured) {
      const auto found = std::ranges::find(claim.judged_on, measured.judged_on);
      const auto position = found == claim.judged_on.end() ? 0 : found - claim.judged_on.begin();
      cells[static_cast<std::size_t>(position) + 2] = cell_of(console, part, measured, with_units);
    }
    table.add(std::move(cells));
  }
  return table;
}

void print_parts(const Console& console, const Claim& claim, const Assessment& assessment) {
  const auto table = parts_table(console, claim, assessment, true);
  const bool fits = table.width() <= console.columns;
  (fits ? table : parts_table(console, claim, assessment, false)).print(console);
}

void print_differences(const Console& console, const Assessment& assessment) {
  const auto sentences = differences(assessment);
  if (sentences.empty()) return;
  console.out << "\nDiffers from the thesis:\n";
  for (std::size_t i = 0; i < sentences.size() && i < differences_shown; ++i)
    print_paragraph(console, sentences[i], "  - ", "    ");
  if (sentences.size() > differences_shown)
    console.out << "  - and " << sentences.size() - differences_shown << " more of the table.\n";
}

/// " (5 of 8 comparisons do)" where some hold and some don't.
std::string held_of(const Claim& claim, const Assessment& assessment, std::string_view column) {
  const auto tally = tally_on(claim, assessment.parts, column);
  if (tally.do_not_hold == 0) return "";
  return " (" + std::to_string(tally.hold) + " of " + output::counted(tally.all(), "comparison", "comparisons") + ")";
}

void print_finding(const Console& console, const Finding& finding, const std::vector<Reading>& readings) {
  const auto& claim = *finding.claim;
  const std::string title = "Claim " + std::to_string(claim.number) + ".";
  console.out << '\n';
  for (const auto& line : output::wrap(title + " " + std::string(claim.statement), console.columns))
    console.out << console.bold(line) << '\n';
  print_paragraph(console, "Thesis: " + std::string(claim.thesis), "", "        ");
  if (finding.assessments.empty()) {
    print_paragraph(console, "Not run. " + finding.why_not_run, "", "");
    for (const auto& sweep : finding.missing_sweeps) console.out << "  " << run_command(sweep) << '\n';
    return;
  }
  std::vector<std::string> rules;
  for (const auto& assessment : finding.assessments) {
    for (const auto& part : assessment.parts) {
      if (std::ranges::find(rules, part.rule) == rules.end()) rules.push_back(part.rule);
    }
  }
  for (const auto& rule : rules) print_paragraph(console, rule, "  - ", "    ");
  for (const auto& assessment : finding.assessments) {
    if (assessment.interpretation) continue;
    const auto key = std::ranges::find(readings, assessment.reading) - readings.begin();
    console.out << '\n';
    print_paragraph(console, title_of(assessment.reading), key_of(static_cast<std::size_t>(key)) + "  ", "   ");
    std::string verdicts;
    for (const auto column : claim.judged_on) {
      verdicts += (verdicts.empty() ? "" : "; ") + ("on " + in_words(column)) + ": " +
                  std::string(to_text(verdict_on(claim, assessment.parts, column))) +
                  held_of(claim, assessment, column);
    }
    print_paragraph(console, verdicts, "   ", "   ");
    console.out << '\n';
    print_parts(console, claim, assessment);
    print_differences(console, assessment);
  }
}

}  // namespace

void print_text(const Console& console, const Findings& findings) {
  console.out << console.bold("What the thesis claims, and what " + findings.database + " shows") << "\n\n";
  print_sweeps(console, findings);
  const auto readings = distinct_readings(findings, false);
  print_summary(console, findings, readings);
  print_interpretations(console, findings);
  for (const auto& finding : findings.findings) print_finding(console, finding, readings);
  std::vector<std::string> missing;
  for (const auto& finding : findings.findings) {
    for (const auto& sweep : finding.missing_sweeps) {
      if (std::ranges::find(missing, sweep) == missing.end()) missing.push_back(sweep);
    }
  }
  if (missing.empty()) return;
  console.out << '\n' << console.bold("Not in this database") << '\n';
  for (const auto& sweep : missing)
    console.out << "  " << run_command(sweep) << " --database " << findings.database << '\n';
}

}  // namespace lamprey::client::report
