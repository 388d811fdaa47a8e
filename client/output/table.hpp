#pragma once

#include "client/output/console.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace lamprey::client::output {

enum class Align : unsigned char { left, right };

/// Rows under headings with a thin rule; columns are as wide as their widest cell and two spaces apart.
class Table {
 public:
  struct Column {
    std::string title;
    Align align = Align::left;
  };

  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// One cell per column; missing ones are empty.
  void add(std::vector<std::string> cells);

  /// Text under the last row, indented and wrapped.
  void note(std::string text);

  bool empty() const { return rows_.empty(); }

  /// Columns that it takes on a terminal, without notes.
  std::size_t width() const;

  /// A line per row on `out`, no white space at line ends.
  void print(const Console& console) const;

 private:
  struct Row {
    std::vector<std::string> cells;
    std::vector<std::string> notes;
  };
  std::vector<std::size_t> widths() const;

  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

/// Names and values, one pair a line, the values below each other.
void print_pairs(const Console& console, const std::vector<std::pair<std::string, std::string>>& pairs);

}  // namespace lamprey::client::output
