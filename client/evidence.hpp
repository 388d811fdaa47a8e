#pragma once

#include "storage/results_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lamprey::client {

/// The answer to a query.
class Rows {
 public:
  explicit Rows(storage::ResultsReader::Table table) : table_(std::move(table)) {}

  std::size_t size() const { return table_.rows.size(); }
  bool empty() const { return table_.rows.empty(); }

  /// Throw std::out_of_range for a column that the query has not. Null is no number, and empty text.
  std::optional<double> number(std::size_t row, std::string_view column) const;
  std::string text(std::size_t row, std::string_view column) const;
  /// The value as it stands in SQL, JSON and tables alike; "null" for null.
  const std::string& literal(std::size_t row, std::string_view column) const;

 private:
  storage::ResultsReader::Table table_;
};

/// Jobs of some sweeps that agree in how the thesis is read: posture, criterion, temperature and the like.
struct Reading {
  std::vector<std::string> sweeps;
  std::vector<std::pair<std::string, std::string>> values;      ///< column of `result` and literal; null: doesn't apply
  std::vector<std::pair<std::string, std::string>> settings{};  ///< the same, of what every job must have

  /// "posture reset, criterion total": the values without those that don't apply.
  std::string text() const;
  /// For SQL on the view `result`: the sweeps, done jobs, the values. A column where a job has null leaves it in: a
  /// temperature says nothing of jobs without annealing.
  std::string condition() const;
  bool operator==(const Reading&) const = default;
};

/// A results database as findings and plots ask it: plain SQL on its views, read-only. One thread. Every function
/// throws StorageError.
class Evidence {
 public:
  explicit Evidence(const std::string& path);

  const std::string& path() const { return path_; }
  const std::vector<storage::Sweep>& sweeps() const { return sweeps_; }
  std::uint32_t science_version() const { return reader_.science_version(); }
  bool has_sweep(std::string_view name) const;

  /// False too if there is no such view.
  bool has_column(const std::string& view, const std::string& column) const;

  Rows query(const std::string& sql) const { return Rows(reader_.query(sql)); }

  /// The readings that done jobs of the sweeps have, told apart by those of the columns that the database has; the
  /// defaults of the parameters come first. A value that applies to some jobs only (a temperature) makes no reading of
  /// the others.
  std::vector<Reading> readings(const std::vector<std::string>& sweeps, const std::vector<std::string>& columns) const;

 private:
  std::string path_;
  storage::ResultsReader reader_;
  std::vector<storage::Sweep> sweeps_;
  mutable std::map<std::string, std::set<std::string>> columns_;  ///< of views that have been asked for
};

/// 'text' as SQL writes it.
std::string sql_text(std::string_view text);
/// The literal of a JSON value (a string in quotes, a number) as SQL writes it.
std::string sql_literal(const std::string& json);
/// The JSON literal of a value typed on a command line: a number if it reads as one, else text.
std::string json_literal(const std::string& text);

}  // namespace lamprey::client
