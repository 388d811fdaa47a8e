#include "client/commands/commands.hpp"
#include "client/failure.hpp"
#include "client/json.hpp"
#include "client/option_checks.hpp"
#include "client/output/formatting.hpp"
#include "client/output/results_table.hpp"
#include "client/results_source.hpp"
#include "experiment/parameters.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <string>

namespace lamprey::client::commands {

namespace {

constexpr std::uint64_t rows_of_a_table = 20;

struct Options {
  std::string sweep;
  std::string database;
  std::optional<std::uint64_t> limit;
  std::vector<std::string> columns;
  ConnectionOptions connection{.join = {}, .timeout_seconds = 5, .file_would_do = true};
};

/// Positions of the named columns; of all if none is named.
std::vector<std::size_t> positions(const std::vector<std::string>& wanted, const std::vector<std::string>& columns) {
  std::vector<std::size_t> positions(columns.size());
  std::iota(positions.begin(), positions.end(), std::size_t{0});
  if (wanted.empty()) return positions;
  positions.clear();
  for (const auto& name : wanted) {
    const auto found = std::ranges::find(columns, name);
    if (found == columns.end()) {
      throw Failure(exit_usage, "unknown_column", unknown_name("column", name, {columns.begin(), columns.end()}));
    }
    positions.push_back(static_cast<std::size_t>(found - columns.begin()));
  }
  return positions;
}

std::vector<std::string> picked(const std::vector<std::string>& values, const std::vector<std::size_t>& positions) {
  std::vector<std::string> result;
  for (const std::size_t i : positions) result.push_back(values[i]);
  return result;
}

/// What a table shows unless told otherwise: the job, the parameters of which the rows have several values, and the
/// totals.
std::vector<std::size_t> telling_columns(const ResultsPage& page) {
  const auto differs = [&](std::size_t i) {
    const std::string* first = nullptr;
    return std::ranges::any_of(page.rows, [&](const auto& row) {
      if (row[i] == "null") return false;  // a parameter that doesn't apply there
      if (first == nullptr) first = &row[i];
      return row[i] != *first;
    });
  };
  static const std::vector<std::string> totals = {"expected_total", "initial_total", "evolved_total",
                                                  "highest_total",  "final_total",   "success_rate"};
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < page.columns.size(); ++i) {
    const auto& name = page.columns[i];
    const bool always = name == "job" || std::ranges::find(totals, name) != totals.end();
    const bool if_telling = name == "replicate" || experiment::find_parameter(name) != nullptr;
    const bool ended_badly =
        name == "state" && std::ranges::any_of(page.rows, [&](const auto& row) { return row[i] != "\"done\""; });
    if (always || ended_badly || (if_telling && differs(i))) shown.push_back(i);
  }
  return shown;
}

/// In which order columns give way where the table is too wide; job and evolved_total stay.
std::vector<std::string> least_telling_first(const ResultsPage& page, const std::vector<std::size_t>& shown) {
  std::vector<std::string> order = {"highest_total", "final_total", "expected_total", "success_rate", "initial_total"};
  for (auto i = shown.rbegin(); i != shown.rend(); ++i) {
    const auto& name = page.columns[*i];
    if (name != "job" && name != "evolved_total") order.push_back(name);
  }
  return order;
}

ExitCode print_table(const ResultsSource& source, const Options& options, const output::Console& console) {
  ResultsPage all;
  const bool more = read_results(source, options.limit.value_or(rows_of_a_table), [&](const ResultsPage& page) {
    all.columns = page.columns;
    all.rows.insert(all.rows.end(), page.rows.begin(), page.rows.end());
  });
  const bool chosen = !options.columns.empty();
  auto shown = positions(options.columns, all.columns);
  if (all.rows.empty()) {
    console.out << "No job of sweep " << options.sweep << " has ended yet.\n";
    return exit_ok;
  }
  if (!chosen) shown = telling_columns(all);
  const auto give_way = chosen ? std::vector<std::string>{} : least_telling_first(all, shown);
  const auto left_out = output::print_results(console, {all.columns, all.rows}, shown, give_way);
  console.out << '\n';
  if (more) {
    const auto count = output::counted(all.rows.size(), "job", "jobs");
    console.out << console.dim("The first " + count + "; --limit 0 shows all.") << '\n';
  }
  if (!chosen) {
    std::string hint =
        std::to_string(shown.size() - left_out.size()) + " of " + std::to_string(all.columns.size()) + " columns";
    if (!left_out.empty()) hint += " (no room for " + output::joined(left_out, ", ") + ")";
    for (const auto& line :
         output::wrap(hint + "; --columns a,b chooses, --format csv or json has all.", console.columns)) {
      console.out << console.dim(line) << '\n';
    }
  }
  return exit_ok;
}

ExitCode print_csv(const ResultsSource& source, const Options& options, const output::Console& console) {
  std::vector<std::size_t> shown;
  bool begun = false;
  read_results(source, options.limit.value_or(0), [&](const ResultsPage& page) {
    if (!std::exchange(begun, true)) {
      shown = positions(options.columns, page.columns);
      console.out << output::csv_line(picked(page.columns, shown));
    }
    for (const auto& row : page.rows) {
      auto values = picked(row, shown);
      std::ranges::transform(values, values.begin(), output::plain);
      console.out << output::csv_line(values);
    }
  });
  return exit_ok;
}

/// The rows are put together as text: they are JSON already, and may be many.
ExitCode print_json(const ResultsSource& source, const Options& options, const output::Console& console) {
  std::vector<std::size_t> shown;
  std::vector<std::string> names;
  std::string rows;
  const bool more = read_results(source, options.limit.value_or(0), [&](const ResultsPage& page) {
    if (names.empty()) {
      shown = positions(options.columns, page.columns);
      for (const auto& name : picked(page.columns, shown)) names.push_back(Json(name).dump());
    }
    for (const auto& row : page.rows) {
      rows += rows.empty() ? "\n    {" : ",\n    {";
      for (std::size_t i = 0; i < shown.size(); ++i) rows += (i > 0 ? ", " : "") + names[i] + ": " + row[shown[i]];
      rows += '}';
    }
  });
  console.out << "{\n  \"schema\": \"lamprey/results/1\",\n  \"sweep\": " << Json(options.sweep).dump()
              << ",\n  \"columns\": [" << output::joined(names, ", ") << "],\n  \"more\": " << (more ? "true" : "false")
              << ",\n  \"rows\": [" << rows << (rows.empty() ? "]\n}\n" : "\n  ]\n}\n");
  return exit_ok;
}

ExitCode print_results(const ResultsSource& source, const Options& options, const Context& context) {
  switch (context.format) {
    case Format::json:
      return print_json(source, options, context.console);
    case Format::csv:
      return print_csv(source, options, context.console);
    case Format::html:
    case Format::table:
      break;
  }
  return print_table(source, options, context.console);
}

ExitCode results(const Options& options, const Context& context) {
  if (!options.database.empty()) {
    return print_results(results_of_database(options.database, options.sweep), options, context);
  }
  CoordinatorConnection connection(context.environment, options.connection);
  return print_results(results_of_coordinator(connection, options.sweep), options, context);
}

}  // namespace

Action declare_results(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Shows a sweep's outcomes, one row per job that has ended: the view 'result' of its database. Without --database "
      "the coordinator is asked. A table shows the parameters that differ and the totals; JSON and CSV have every "
      "column and every digit.");
  app.add_option("SWEEP", options->sweep, "Name or id")->required();
  app.add_option("--database", options->database, "Read this database file")->type_name("FILE");
  app.add_option("--limit", options->limit, "At most this many rows; 0: all (default: 20 in a table, else all)")
      ->type_name("N")
      ->check(whole_number(0, std::numeric_limits<std::uint32_t>::max()));
  app.add_option("--columns", options->columns, "Only these columns, in this order")
      ->type_name("NAME,NAME...")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_connection_options(app, options->connection);
  app.footer(
      "Example\n  lamprey results quickstart --database results.db --columns job,mutation,steps,evolved_total --limit "
      "5");
  return [options](const Context& context) { return results(*options, context); };
}

}  // namespace lamprey::client::commands
