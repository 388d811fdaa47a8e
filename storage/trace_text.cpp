#include "storage/trace_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <type_traits>
#include <utility>

namespace lamprey::storage {

namespace {

/// Longest row: ten digits of a cycle, four doubles of at most 24 characters, brackets and commas.
constexpr std::size_t longest_row = 128;

/// Longest end of a measure: ten digits of an index, a double, bracket and commas.
constexpr std::size_t longest_measure_end = 40;

template <typename Number>
char* write_number(char* position, char* end, Number value) {
  return std::to_chars(position, end, value).ptr;
}

/// Reads the characters of a text one after the other; once something doesn't fit, `good` stays false.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : position_(text.data()), end_(text.data() + text.size()) {}

  bool take(char expected) {
    if (position_ == end_ || *position_ != expected) return false;
    ++position_;
    return true;
  }

  template <typename Number>
  Number number() {
    Number value{};
    const auto [after, error] = std::from_chars(position_, end_, value);
    if (error != std::errc{}) good_ = false;
    if constexpr (std::is_floating_point_v<Number>) good_ = good_ && std::isfinite(value);
    position_ = after;
    return value;
  }

  /// The characters up to a quotation mark, which is passed over.
  std::string_view quoted_text() {
    require('"');
    const char* const end = std::find(position_, end_, '"');
    const std::string_view text(position_, static_cast<std::size_t>(end - position_));
    position_ = end;
    require('"');
    return text;
  }

  void require(char expected) { good_ = take(expected) && good_; }
  bool good() const { return good_; }
  bool at_end() const { return position_ == end_; }

 private:
  const char* position_;
  const char* end_;
  bool good_ = true;
};

}  // namespace

void write_trace(std::span<const experiment::AcceptedChange> trace, std::string& text) {
  text.clear();
  text += '[';
  std::array<char, longest_row> row{};
  char* const end = row.data() + row.size();
  for (const auto& change : trace) {
    if (text.size() > 1) text += ',';
    char* position = row.data();
    *position++ = '[';
    position = write_number(position, end, change.cycle);
    for (const double value : {change.score.stability, change.score.distance, change.score.fuel, change.score.total}) {
      *position++ = ',';
      position = write_number(position, end, value);
    }
    *position++ = ']';
    text.append(row.data(), position);
  }
  text += ']';
}

std::optional<std::vector<experiment::AcceptedChange>> read_trace(std::string_view text) {
  Scanner scanner(text);
  std::vector<experiment::AcceptedChange> trace;
  trace.reserve(static_cast<std::size_t>(std::ranges::count(text, '[')));
  scanner.require('[');
  for (bool more = !scanner.take(']'); more && scanner.good(); more = scanner.take(',')) {
    scanner.require('[');
    experiment::AcceptedChange change;
    change.cycle = scanner.number<std::uint32_t>();
    for (double* value : {&change.score.stability, &change.score.distance, &change.score.fuel, &change.score.total}) {
      scanner.require(',');
      *value = scanner.number<double>();
    }
    scanner.require(']');
    trace.push_back(change);
  }
  if (!trace.empty()) scanner.require(']');
  if (!scanner.good() || !scanner.at_end()) return std::nullopt;
  return trace;
}

void write_measures(std::span<const experiment::Measure> measures, std::string& text) {
  text.clear();
  text += '[';
  std::array<char, longest_measure_end> numbers{};
  char* const end = numbers.data() + numbers.size();
  for (const auto& measure : measures) {
    if (text.size() > 1) text += ',';
    char* position = write_number(numbers.data(), end, measure.index);
    *position++ = ',';
    position = write_number(position, end, measure.value);
    text.append("[\"").append(measure.name).append("\",").append(numbers.data(), position).append("]");
  }
  text += ']';
}

std::optional<std::vector<experiment::Measure>> read_measures(std::string_view text) {
  Scanner scanner(text);
  std::vector<experiment::Measure> measures;
  scanner.require('[');
  for (bool more = !scanner.take(']'); more && scanner.good(); more = scanner.take(',')) {
    scanner.require('[');
    experiment::Measure measure;
    measure.name = scanner.quoted_text();
    scanner.require(',');
    measure.index = scanner.number<std::uint32_t>();
    scanner.require(',');
    measure.value = scanner.number<double>();
    scanner.require(']');
    measures.push_back(std::move(measure));
  }
  if (!measures.empty()) scanner.require(']');
  if (!scanner.good() || !scanner.at_end()) return std::nullopt;
  return measures;
}

std::string shortest_text(double value) {
  std::array<char, 32> text{};
  return {text.data(), write_number(text.data(), text.data() + text.size(), value)};
}

}  // namespace lamprey::storage
