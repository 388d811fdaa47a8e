#include "client/commands/commands.hpp"
#include "client/json.hpp"
#include "client/output/formatting.hpp"
#include "client/output/progress.hpp"
#include "client/output/table.hpp"
#include "storage/results_reader.hpp"

#include <chrono>
#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

constexpr std::size_t discrepancies_of_a_table = 50;

struct Options {
  std::string database;
  bool quiet = false;
};

Json json_of(const std::string& path, const storage::Verification& found) {
  Json json = document("verify");
  json["database"] = path;
  json["jobs"] = found.jobs;
  json["trace_rows"] = found.trace_rows;
  json["discrepancies"] = Json::array();
  for (const auto& discrepancy : found.discrepancies) {
    json["discrepancies"].push_back({{"sweep", discrepancy.sweep},
                                     {"job", discrepancy.job ? Json(*discrepancy.job) : Json(nullptr)},
                                     {"column", discrepancy.column},
                                     {"text", discrepancy.text}});
  }
  return json;
}

void print_table(const output::Console& console, const std::string& path, const storage::Verification& found) {
  const auto wrong = found.discrepancies.size();
  console.out << path << ": " << output::counted(found.jobs, "job", "jobs") << " and "
              << output::counted(found.trace_rows, "trace row", "trace rows") << " checked, "
              << (wrong == 0 ? "all in order" : output::counted(wrong, "discrepancy", "discrepancies")) << '\n';
  if (wrong == 0) return;
  output::Table table({{"sweep"}, {"job", output::Align::right}, {"column"}, {"what is wrong"}});
  for (const auto& discrepancy : found.discrepancies) {
    if (&discrepancy - found.discrepancies.data() >= static_cast<std::ptrdiff_t>(discrepancies_of_a_table)) break;
    table.add({discrepancy.sweep, discrepancy.job ? std::to_string(*discrepancy.job) : "", discrepancy.column,
               discrepancy.text});
  }
  console.out << '\n';
  table.print(console);
  if (wrong > discrepancies_of_a_table) {
    console.out << "... and " << output::with_thousands(wrong - discrepancies_of_a_table)
                << " more (--format json has all)\n";
  }
}

ExitCode verify(const Options& options, const Context& context) {
  output::ProgressDisplay display(context.console, options.quiet);
  const auto found = storage::verify(options.database, [&](std::uint64_t rows) {
    display.show("checking  " + output::counted(rows, "job", "jobs"), std::chrono::steady_clock::now());
  });
  display.clear();
  if (context.format == Format::json) {
    print(context.console, json_of(options.database, found));
  } else {
    print_table(context.console, options.database, found);
  }
  return found.discrepancies.empty() ? exit_ok : exit_mismatch;
}

}  // namespace

Action declare_verify(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Checks a results database against itself: recomputes from the stored values each job's digest and identity, the "
      "parameters from the sweep's specification and the counters from the rows, and runs SQLite's integrity check. A "
      "flipped byte is found; nothing is computed anew (replay does that). Ends with exit code 5 if anything is "
      "wrong.");
  app.add_option("DATABASE", options->database, "Results database")->required();
  app.add_flag("-q,--quiet", options->quiet, "No progress");
  return [options](const Context& context) { return verify(*options, context); };
}

}  // namespace lamprey::client::commands
