#include "client/plot/script.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace lamprey::client::plot {

std::string_view colour_of(std::size_t number) {
  static constexpr std::array colours = {colour::blue,   colour::vermilion, colour::green, colour::orange,
                                         colour::purple, colour::sky,       colour::black};
  return colours[number % colours.size()];
}

std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char character : text) {
    if (character == '\'') result += '\'';
    result += character == '\n' ? ' ' : character;
  }
  return result + "'";
}

std::string number(double value) {
  if (!std::isfinite(value)) return "NaN";
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6).ptr;
  return {text.data(), end};
}

std::string data_block(std::string_view name, const std::vector<std::vector<double>>& rows) {
  std::string text = "$" + std::string(name) + " << EOD\n";
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? " " : "") + number(row[i]);
    text += '\n';
  }
  return text + "EOD\n";
}

std::string common_style() {
  return "set encoding utf8\n"
         "set border 3 linecolor rgb '#6B7684' linewidth 1\n"
         "set tics nomirror textcolor rgb '#222222'\n"
         "set grid ytics linetype 1 linecolor rgb '#E3E8EE' linewidth 1\n"
         "set style fill solid 1 noborder\n"
         "set key noenhanced\n";
}

namespace {

/// The text between double quotes, in which gnuplot reads \n as a line's end.
/// gnuplot runs what stands between backquotes as a command of the shell, also within double quotes: titles come from
/// databases, so an apostrophe takes their place.
std::string in_double_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char character : text) {
    if (character == '`') {
      result += '\'';
    } else if (character == '\n') {
      result += "\\n";
    } else {
      if (character == '"' || character == '\\') result += '\\';
      result += character;
    }
  }
  return result + "\"";
}

}  // namespace

std::string labels(std::string_view title, std::string_view x, std::string_view y) {
  return "set title " + in_double_quotes(title) + "\nset xlabel " + in_quotes(x) + "\nset ylabel " + in_quotes(y) +
         "\n";
}

std::string multiplot(int rows, int columns, std::string_view title, std::string_view note) {
  const std::string text = std::string(title) + (note.empty() ? "" : "\n" + std::string(note));
  return "set multiplot layout " + std::to_string(rows) + "," + std::to_string(columns) + " title " +
         in_double_quotes(text) + " font ',15' noenhanced\n";
}

std::string plot_command(const std::vector<std::string>& items, std::string_view command) {
  std::string text(command);
  for (std::size_t i = 0; i < items.size(); ++i) text += (i > 0 ? ", \\\n  " : " ") + items[i];
  return text + "\n";
}

}  // namespace lamprey::client::plot
