#include "client/output/table.hpp"

#include "client/output/formatting.hpp"

#include <algorithm>
#include <utility>

namespace lamprey::client::output {

namespace {

constexpr std::size_t gap = 2;
constexpr std::size_t note_indent = 4;

std::string without_trailing_space(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace

void Table::add(std::vector<std::string> cells) {
  cells.resize(columns_.size());
  rows_.push_back({std::move(cells), {}});
}

void Table::note(std::string text) {
  rows_.back().notes.push_back(std::move(text));
}

std::vector<std::size_t> Table::widths() const {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::size_t widest = output::width(columns_[i].title);
    for (const auto& row : rows_) widest = std::max(widest, output::width(row.cells[i]));
    widths.push_back(widest);
  }
  return widths;
}

std::size_t Table::width() const {
  std::size_t sum = columns_.empty() ? 0 : (columns_.size() - 1) * gap;
  for (const std::size_t width : widths()) sum += width;
  return sum;
}

void Table::print(const Console& console) const {
  const auto column_widths = widths();
  const auto line = [&](const auto& cell_of) {
    std::string text;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::string& cell = cell_of(i);
      const std::string padding(column_widths[i] - output::width(cell), ' ');
      if (i > 0) text.append(gap, ' ');
      text += columns_[i].align == Align::right ? padding + cell : cell + padding;
    }
    return without_trailing_space(std::move(text));
  };
  console.out << console.bold(line([&](std::size_t i) -> const std::string& { return columns_[i].title; })) << '\n';
  std::string rule;
  for (std::size_t i = 0; i < width(); ++i) rule += console.unicode ? "─" : "-";
  console.out << console.dim(rule) << '\n';
  for (const auto& row : rows_) {
    console.out << line([&](std::size_t i) -> const std::string& { return row.cells[i]; }) << '\n';
    for (const auto& note : row.notes) {
      for (const auto& part : wrap(note, console.columns - note_indent)) {
        console.out << std::string(note_indent, ' ') << console.dim(part) << '\n';
      }
    }
  }
}

void print_pairs(const Console& console, const std::vector<std::pair<std::string, std::string>>& pairs) {
  std::size_t widest = 0;
  for (const auto& [name, value] : pairs) widest = std::max(widest, width(name));
  for (const auto& [name, value] : pairs) {
    console.out << console.dim(name) << std::string(widest - width(name) + gap, ' ') << value << '\n';
  }
}

}  // namespace lamprey::client::output
