#include "client/report/chapter_8_queries.hpp"

#include "client/output/formatting.hpp"

#include <algorithm>

namespace lamprey::client::report {

namespace {

/// Chapter 8 has no other network; a sweep of the same name might.
const std::string of_published_system = " AND network = 'four_mother'";

const std::vector<std::string> compared = {"evolved_total", "highest_total", "success_rate"};

std::string among_clause(const std::string& among) {
  return among.empty() ? "" : " AND " + among;
}

std::string with_comma(const std::vector<std::string>& columns) {
  return columns.empty() ? "" : column_list(columns) + ", ";
}

std::string group_clause(const std::vector<std::string>& columns) {
  return columns.empty() ? "" : "\nGROUP BY " + column_list(columns) + " ORDER BY " + column_list(columns);
}

}  // namespace

const std::vector<std::string> fitness_columns = {"evolved_total", "highest_total"};
const std::vector<std::string> grid_axes = {"mutation",           "steps",
                                            "acceptance",         "equilibrium_disturbance",
                                            "mutation_size",      "system_disturbance",
                                            "required_stability", "required_distance",
                                            "required_fuel"};

std::string column_list(const std::vector<std::string>& columns) {
  return output::joined(columns, ", ");
}

std::string pairing_sql(const Reading& reading, const Pairing& pairing) {
  std::vector<std::string> cell = pairing.kept;
  const auto has = [](const std::vector<std::string>& columns, const std::string& column) {
    return std::ranges::find(columns, column) != columns.end();
  };
  for (const auto& axis : grid_axes) {
    if (!has(cell, axis) && !has(pairing.differing, axis)) cell.push_back(axis);
  }
  cell.emplace_back("replicate");
  std::string sql = "WITH cell AS (\n  SELECT " + with_comma(pairing.kept) +
                    "avg(expected_total) AS expected, avg(success_rate) AS success_level";
  for (const auto& column : compared) {
    sql += ",\n    avg(CASE WHEN " + pairing.first + " THEN " + column + " END) - avg(CASE WHEN " + pairing.second +
           " THEN " + column + " END) AS " + column;
  }
  sql += "\n  FROM result\n  WHERE " + reading.condition() + of_published_system + among_clause(pairing.among) +
         " AND (" + pairing.first + " OR " + pairing.second + ")\n  GROUP BY " + column_list(cell) + ")\nSELECT " +
         with_comma(pairing.kept) + "count(*) AS n, avg(expected) AS expected, avg(success_level) AS success_level";
  for (const auto& column : compared) {
    sql += ",\n  avg(" + column + ") AS " + column + ", avg(" + column + " * " + column + ") AS " + column + "_squared";
  }
  return sql + "\nFROM cell WHERE evolved_total IS NOT NULL" + group_clause(pairing.kept);
}

std::string averages_sql(const Reading& reading, const std::vector<std::string>& kept, const std::string& among) {
  std::string sql = "SELECT " + with_comma(kept) + "count(*) AS n, avg(expected_total) AS expected";
  for (const auto& column : compared) {
    sql += ",\n  avg(" + column + ") AS " + column + ", avg(" + column + " * " + column + ") AS " + column + "_squared";
  }
  for (const auto& column : fitness_columns) {
    const std::string distance = column + " - expected_total";
    sql += ",\n  avg(" + distance + ") AS " + column + "_reached, avg((" + distance + ") * (" + distance + ")) AS " +
           column + "_reached_squared";
  }
  return sql + "\nFROM result\nWHERE " + reading.condition() + of_published_system + among_clause(among) +
         group_clause(kept);
}

}  // namespace lamprey::client::report
