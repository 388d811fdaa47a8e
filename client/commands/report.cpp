#include "client/commands/commands.hpp"
#include "client/failure.hpp"
#include "client/output/progress.hpp"
#include "client/plot/figure.hpp"
#include "client/report/render.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string database;
  std::string output;
  bool quiet = false;
};

/// The figures of the claims that the database says something of, each with the first claim that has it. One that
/// cannot be drawn, say for want of its sweep, is left out and named on standard error; so are all without gnuplot.
report::Pictures pictures_of(const report::Findings& findings, const Evidence& evidence, const Context& context,
                             output::ProgressDisplay& display) {
  report::Pictures pictures;
  std::set<std::string_view> done;
  for (std::size_t i = 0; i < findings.findings.size(); ++i) {
    const auto& finding = findings.findings[i];
    if (std::ranges::all_of(finding.assessments, &report::Assessment::interpretation)) continue;
    for (const auto name : finding.claim->figures) {
      if (!done.insert(name).second) continue;
      const auto* figure = plot::find_figure(name);
      display.show("drawing figure " + std::string(name), std::chrono::steady_clock::now());
      try {
        plot::Request request;
        request.evidence = &evidence;
        pictures[i].push_back(plot::svg_element(figure->make(request, *figure), context.environment.interrupted));
      } catch (const Failure& failure) {
        if (failure.exit_code() == exit_interrupted) throw;
        display.clear();
        const bool no_gnuplot = failure.code() == "program_missing";
        context.console.err << "lamprey: " << (no_gnuplot ? "the figures are" : "figure " + std::string(name) + " is")
                            << " left out: " << failure.messages().front() << '\n';
        if (no_gnuplot) return pictures;
      }
    }
  }
  return pictures;
}

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw Failure(exit_failure, "output", path + " cannot be written");
}

std::string rendered(const report::Findings& findings, const Evidence& evidence, const Context& context,
                     output::ProgressDisplay& display) {
  if (context.format == Format::html)
    return report::as_html(findings, pictures_of(findings, evidence, context, display));
  std::ostringstream text;
  const auto& console = context.console;
  const output::Console to_text{.out = text,
                                .err = console.err,
                                .out_is_terminal = false,
                                .err_is_terminal = console.err_is_terminal,
                                .colour = false,
                                .unicode = console.unicode,
                                .columns = console.columns};
  if (context.format == Format::json) {
    print(to_text, report::as_json(findings));
  } else {
    report::print_text(to_text, findings);
  }
  return text.str();
}

ExitCode report_findings(const Options& options, const Context& context) {
  output::ProgressDisplay display(context.console, options.quiet);
  const Evidence evidence(options.database);
  const auto findings = report::assess_claims(evidence, [&](int number) {
    if (context.environment.interrupted())
      throw Failure(exit_interrupted, "interrupted", std::string("interrupted; nothing was written"));
    display.show("claim " + std::to_string(number), std::chrono::steady_clock::now());
  });
  if (options.output.empty() && context.format == Format::table) {
    display.clear();
    report::print_text(context.console, findings);
    return exit_ok;
  }
  const auto text = rendered(findings, evidence, context, display);
  display.clear();
  if (options.output.empty()) {
    context.console.out << text;
  } else {
    write(options.output, text);
    context.console.err << "Written to " << options.output << '\n';
  }
  return exit_ok;
}

}  // namespace

Action declare_report(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Holds each claim of the thesis against the results in a database: what was measured, with a confidence "
      "interval, "
      "the rule by which it is judged, and whether it holds; separately for every reading of the thesis (posture, "
      "criterion, temperature, cycles) that the database has jobs of. JSON and HTML have the SQL too, and HTML the "
      "figures. Changes nothing; a claim that does not hold is no error.");
  app.add_option("DATABASE", options->database, "Results database")->required();
  app.add_option("--output", options->output, "Write to this file instead of standard output")->type_name("FILE");
  app.add_flag("-q,--quiet", options->quiet, "No progress");
  app.footer("Examples\n  lamprey report results.db\n  lamprey report results.db --format html --output findings.html");
  return [options](const Context& context) { return report_findings(*options, context); };
}

}  // namespace lamprey::client::commands
