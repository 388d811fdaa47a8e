#include "client/output/formatting.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <ctime>

namespace lamprey::client::output {

namespace {

constexpr std::string_view style_end = "\x1b[0m";

bool begins_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

/// Bytes of the style that the text begins with; 0 if it begins with none.
std::size_t style_length(std::string_view text) {
  if (!text.starts_with("\x1b[")) return 0;
  const auto end = text.find('m');
  return end == std::string_view::npos ? 0 : end + 1;
}

/// Two units of time, the smaller one left out where it is 0.
std::string two_units(std::uint64_t large, const char* large_unit, std::uint64_t small, const char* small_unit) {
  std::string text = with_thousands(large) + large_unit;
  if (small > 0) text += " " + std::to_string(small) + small_unit;
  return text;
}

/// Whole from 10 on, one decimal below.
std::string two_digits(double number) {
  const double tenths = std::round(number * 10);
  if (tenths >= 100) return with_thousands(static_cast<std::uint64_t>(std::llround(number)));
  return shortest(tenths / 10);
}

}  // namespace

std::string with_thousands(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string shortest(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

std::string rounded(double number) {
  constexpr int significant_digits = 6;
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, significant_digits).ptr;
  return {text.data(), end};
}

std::string duration(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0) return "?";
  if (seconds < 59.5) return two_digits(seconds) + " s";
  constexpr double century = 3.2e9;
  const auto whole = static_cast<std::uint64_t>(std::llround(std::min(seconds, century)));
  if (whole < 3600) return two_units(whole / 60, " min", whole % 60, " s");
  const std::uint64_t minutes = (whole + 30) / 60;
  if (minutes < std::uint64_t{24} * 60) return two_units(minutes / 60, " h", minutes % 60, " min");
  const std::uint64_t hours = (minutes + 30) / 60;
  return two_units(hours / 24, " d", hours % 24, " h");
}

std::string rate(double per_second) {
  if (!std::isfinite(per_second) || per_second < 0) return "? jobs/s";
  if (per_second >= 1 || per_second == 0) return two_digits(per_second) + " jobs/s";
  if (per_second * 60 >= 1) return two_digits(per_second * 60) + " jobs/min";
  return two_digits(per_second * 3600) + " jobs/h";
}

std::string date_and_time(std::int64_t unix_milliseconds) {
  const std::time_t seconds = static_cast<std::time_t>(unix_milliseconds / 1000);
  std::tm parts{};
  std::array<char, 32> text{};
  if (::gmtime_r(&seconds, &parts) == nullptr) return "?";
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &parts)};
}

std::string counted(std::uint64_t number, std::string_view one, std::string_view several) {
  return with_thousands(number) + " " + std::string(number == 1 ? one : several);
}

std::size_t width(std::string_view text) {
  std::size_t columns = 0;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t style = style_length(text.substr(i));
    if (style == 0 && begins_character(text[i])) ++columns;
    i += std::max<std::size_t>(style, 1);
  }
  return columns;
}

std::string cut(std::string_view text, std::size_t columns, std::string_view ellipsis) {
  if (width(text) <= columns) return std::string(text);
  const std::size_t kept = columns - std::min(columns, width(ellipsis));
  std::size_t bytes = 0;
  bool styled = false;
  for (std::size_t characters = 0; bytes < text.size();) {
    const std::size_t style = style_length(text.substr(bytes));
    if (style == 0 && begins_character(text[bytes]) && characters++ == kept) break;
    if (style > 0) styled = text.substr(bytes, style) != style_end;
    bytes += std::max<std::size_t>(style, 1);
  }
  return std::string(text.substr(0, bytes)) + std::string(ellipsis) + std::string(styled ? style_end : "");
}

std::string without_controls(std::string_view text) {
  std::string safe;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool second = i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (byte == 0xC2 && second) {  // U+0080 to U+009F
      safe += '?';
      ++i;
    } else {
      safe += byte < 0x20 || byte == 0x7F ? '?' : text[i];
    }
  }
  return safe;
}

std::vector<std::string> wrap(std::string_view text, std::size_t columns) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (word.empty()) continue;
    if (!line.empty() && width(line) + 1 + width(word) > columns) {
      lines.push_back(std::move(line));
      line.clear();
    }
    if (!line.empty()) line += ' ';
    line += word;
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
}

std::string joined(const std::vector<std::string>& items, std::string_view separator) {
  std::string text;
  for (const auto& item : items) {
    if (!text.empty()) text += separator;
    text += item;
  }
  return text;
}

std::string list_in_short(const std::vector<std::string>& items, std::size_t columns, std::string_view ellipsis) {
  // Longer lists are not even written out to be measured.
  if (items.size() <= columns) {
    if (auto all = joined(items, ", "); width(all) <= columns) return all;
  }
  if (items.size() < 3) return cut(joined(items, ", "), columns, ellipsis);
  const std::string tail = ", " + std::string(ellipsis) + ", " + items.back();
  std::string head = items.front();
  for (std::size_t i = 1; i + 1 < items.size(); ++i) {
    if (width(head) + 2 + width(items[i]) + width(tail) > columns) break;
    head += ", " + items[i];
  }
  return cut(head + tail, columns, ellipsis);
}

}  // namespace lamprey::client::output
