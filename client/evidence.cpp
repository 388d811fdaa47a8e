#include "client/evidence.hpp"

#include "client/json.hpp"
#include "client/output/results_table.hpp"
#include "experiment/parameters.hpp"

#include <algorithm>
#include <stdexcept>

namespace lamprey::client {

namespace {

/// Defaults before other values, then in order: of numbers by size.
struct Rank {
  bool other = true;
  double number = 0;
  std::string text;
  auto operator<=>(const Rank&) const = default;
};

Rank rank_of(const std::string& column, const std::string& literal) {
  const auto json = Json::parse(literal, nullptr, false);
  Rank rank{.text = literal};
  if (json.is_number()) rank.number = json.get<double>();
  const auto* parameter = experiment::find_parameter(column);
  if (parameter == nullptr) return rank;
  const Json standard = Json::parse(
      std::visit([](const auto& value) { return Json(value).dump(); }, parameter->default_value), nullptr, false);
  rank.other = json != standard;
  return rank;
}

/// Whether the jobs of `special` are all that the jobs of `general` could be compared with: where they differ,
/// `general` has null.
bool covers(const Reading& special, const Reading& general) {
  if (special == general || special.sweeps != general.sweeps) return false;
  for (std::size_t i = 0; i < general.values.size(); ++i) {
    if (general.values[i] != special.values[i] && general.values[i].second != "null") return false;
  }
  return true;
}

}  // namespace

const std::string& Rows::literal(std::size_t row, std::string_view column) const {
  const auto found = std::ranges::find(table_.columns, column);
  if (found == table_.columns.end()) throw std::out_of_range("no column " + std::string(column));
  return table_.rows.at(row)[static_cast<std::size_t>(found - table_.columns.begin())];
}

std::optional<double> Rows::number(std::size_t row, std::string_view column) const {
  const auto json = Json::parse(literal(row, column), nullptr, false);
  if (!json.is_number()) return std::nullopt;
  return json.get<double>();
}

std::string Rows::text(std::size_t row, std::string_view column) const {
  return output::plain(literal(row, column));
}

std::string Reading::text() const {
  std::string text;
  for (const auto& [column, literal] : values) {
    if (literal == "null") continue;
    text += (text.empty() ? "" : ", ") + column + " " + output::readable(literal);
  }
  for (const auto& [column, literal] : settings) {
    text += (text.empty() ? "" : ", ") + column + " " + output::readable(literal);
  }
  return text;
}

std::string Reading::condition() const {
  std::string names;
  for (const auto& sweep : sweeps) names += (names.empty() ? "" : ", ") + sql_text(sweep);
  std::string condition = "sweep IN (" + names + ") AND state = 'done'";
  for (const auto& [column, literal] : values) {
    if (literal == "null") {
      condition += " AND " + column + " IS NULL";
    } else {
      condition += " AND coalesce(" + column + ", " + sql_literal(literal) + ") = " + sql_literal(literal);
    }
  }
  for (const auto& [column, literal] : settings) condition += " AND " + column + " = " + sql_literal(literal);
  return condition;
}

Evidence::Evidence(const std::string& path) : path_(path), reader_(path), sweeps_(reader_.sweeps()) {}

bool Evidence::has_sweep(std::string_view name) const {
  return std::ranges::any_of(sweeps_, [&](const auto& sweep) { return sweep.what.name == name; });
}

bool Evidence::has_column(const std::string& view, const std::string& column) const {
  const auto [known, is_new] = columns_.try_emplace(view);
  if (is_new) {
    const auto rows = query("SELECT name FROM pragma_table_info(" + sql_text(view) + ")");
    for (std::size_t i = 0; i < rows.size(); ++i) known->second.insert(rows.text(i, "name"));
  }
  return known->second.contains(column);
}

std::vector<Reading> Evidence::readings(const std::vector<std::string>& sweeps,
                                        const std::vector<std::string>& columns) const {
  std::vector<std::string> present;
  std::ranges::copy_if(columns, std::back_inserter(present),
                       [&](const auto& column) { return has_column("result", column); });
  Reading all{.sweeps = sweeps, .values = {}};
  std::string list;
  for (const auto& column : present) list += (list.empty() ? "" : ", ") + column;
  const auto rows = query("SELECT DISTINCT " + (list.empty() ? "1" : list) + " FROM result WHERE " + all.condition());
  std::vector<Reading> found;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Reading reading = all;
    for (const auto& column : present) reading.values.emplace_back(column, rows.literal(i, column));
    found.push_back(std::move(reading));
  }
  std::vector<Reading> readings;
  for (const auto& reading : found) {
    if (std::ranges::none_of(found, [&](const auto& other) { return covers(other, reading); }))
      readings.push_back(reading);
  }
  std::ranges::sort(readings, {}, [](const Reading& reading) {
    std::vector<Rank> ranks;
    for (const auto& [column, literal] : reading.values) ranks.push_back(rank_of(column, literal));
    return ranks;
  });
  return readings;
}

std::string sql_text(std::string_view text) {
  std::string quoted = "'";
  for (const char character : text) quoted += character == '\'' ? std::string("''") : std::string(1, character);
  return quoted + "'";
}

std::string sql_literal(const std::string& json) {
  const auto value = Json::parse(json, nullptr, false);
  return value.is_string() ? sql_text(value.get<std::string>()) : json;
}

std::string json_literal(const std::string& text) {
  const auto value = Json::parse(text, nullptr, false);
  return value.is_number() ? text : Json(text).dump();
}

}  // namespace lamprey::client
