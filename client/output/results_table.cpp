#include "client/output/results_table.hpp"

#include "client/output/formatting.hpp"
#include "client/output/table.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

namespace lamprey::client::output {

namespace {

bool is_number(const std::string& literal) {
  return !literal.empty() && (literal[0] == '-' || (literal[0] >= '0' && literal[0] <= '9'));
}

Table make_table(const ResultRows& results, const std::vector<std::size_t>& shown) {
  std::vector<Table::Column> columns;
  for (const std::size_t i : shown) {
    const bool numbers =
        std::ranges::all_of(results.rows, [&](const auto& row) { return is_number(row[i]) || row[i] == "null"; });
    columns.push_back({results.columns[i], numbers ? Align::right : Align::left});
  }
  Table table(std::move(columns));
  for (const auto& row : results.rows) {
    std::vector<std::string> cells;
    for (const std::size_t i : shown) cells.push_back(readable(row[i]));
    table.add(std::move(cells));
  }
  return table;
}

}  // namespace

std::string plain(const std::string& literal) {
  if (literal == "null") return {};
  if (!literal.starts_with('"')) return literal;
  const auto value = nlohmann::json::parse(literal, nullptr, false);
  return value.is_string() ? value.get<std::string>() : literal;
}

std::string readable(const std::string& literal) {
  const bool real = is_number(literal) && literal.find_first_of(".eE") != std::string::npos;
  double number = 0;
  if (real && std::from_chars(literal.data(), literal.data() + literal.size(), number).ec == std::errc()) {
    return rounded(number);
  }
  return plain(literal);
}

std::string csv_line(const std::vector<std::string>& values) {
  std::string line;
  bool first = true;
  for (const auto& value : values) {
    if (!first) line += ',';
    first = false;
    if (value.find_first_of(",\"\r\n") == std::string::npos) {
      line += value;
      continue;
    }
    line += '"';
    for (const char c : value) line += c == '"' ? std::string("\"\"") : std::string(1, c);
    line += '"';
  }
  return line + '\n';
}

std::vector<std::string> print_results(const Console& console, const ResultRows& results,
                                       std::vector<std::size_t> shown, const std::vector<std::string>& give_way) {
  std::vector<std::string> left_out;
  Table table = make_table(results, shown);
  for (const auto& name : give_way) {
    if (table.width() <= console.columns) break;
    if (std::erase_if(shown, [&](std::size_t i) { return results.columns[i] == name; }) == 0) continue;
    left_out.push_back(name);
    table = make_table(results, shown);
  }
  table.print(console);
  return left_out;
}

}  // namespace lamprey::client::output
