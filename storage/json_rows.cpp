#include "storage/json_rows.hpp"

#include "storage/trace_text.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace lamprey::storage {

namespace {

std::string json_text(std::string_view text) {
  // A database may hold text that isn't UTF-8 and JSON may not.
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_value(const Statement& row, int column) {
  switch (row.type(column)) {
    case SQLITE_INTEGER:
      return std::to_string(row.integer(column));
    case SQLITE_FLOAT:
      return std::isfinite(row.real(column)) ? shortest_text(row.real(column)) : "null";
    case SQLITE_TEXT:
      return json_text(row.text(column));
    case SQLITE_BLOB:
      return '"' + experiment::to_hex(row.blob(column)) + '"';
    default:
      return "null";
  }
}

}  // namespace

ResultsReader::Table read_table(Statement& statement) {
  ResultsReader::Table table;
  const int columns = statement.columns();
  for (int column = 0; column < columns; ++column) table.columns.emplace_back(statement.name(column));
  while (statement.step()) {
    auto& row = table.rows.emplace_back();
    row.reserve(static_cast<std::size_t>(columns));
    for (int column = 0; column < columns; ++column) row.push_back(json_value(statement, column));
  }
  return table;
}

}  // namespace lamprey::storage
