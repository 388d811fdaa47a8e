#include "experiment/problem.hpp"

#include <algorithm>
#include <cctype>

namespace lamprey::experiment {

namespace {

/// Longer names are not compared: nobody mistypes them by a slip of the finger, and the comparison is quadratic.
constexpr std::size_t longest_compared_name = 64;

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return lower;
}

/// Edits (insert, delete, replace, swap two neighbours) from one text to the other: optimal string alignment.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> before_last(to.size() + 1);
  std::vector<std::size_t> last(to.size() + 1);
  std::vector<std::size_t> row(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
    before_last.swap(last);
    last.swap(row);
  }
  return last[to.size()];
}

std::string all_texts(const std::vector<Problem>& problems) {
  std::string text;
  for (const auto& problem : problems) {
    if (!text.empty()) text += '\n';
    text += problem.text();
  }
  return text;
}

/// Length of the UTF-8 character (RFC 3629: shortest form, no surrogates) that the text begins with; 0 if it is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return continues(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    const bool overlong = lead == 0xE0 && byte(1) < 0xA0;
    const bool surrogate = lead == 0xED && byte(1) > 0x9F;
    return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    const bool overlong = lead == 0xF0 && byte(1) < 0x90;
    const bool beyond_unicode = lead == 0xF4 && byte(1) > 0x8F;
    return continues(1) && continues(2) && continues(3) && !overlong && !beyond_unicode ? 4 : 0;
  }
  return 0;
}

/// C0 and C1 controls (the latter are two bytes in UTF-8): terminals act on them.
bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  return first < 0x20 || first == 0x7F || (first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0);
}

}  // namespace

std::string Problem::text() const {
  std::string text = file;
  if (line > 0) {
    if (!text.empty()) text += ':';
    text += std::to_string(line) + ':' + std::to_string(column);
  }
  if (!text.empty()) text += ": ";
  if (!field.empty()) text += field + ": ";
  return text + message;
}

InvalidInput::InvalidInput(std::vector<Problem> problems)
    : std::runtime_error(all_texts(problems)), problems_(std::move(problems)) {}

bool is_within(std::string_view field, std::string_view holder) {
  return field.starts_with(holder) &&
         (field.size() == holder.size() || field[holder.size()] == '.' || field[holder.size()] == '[');
}

void Findings::add(std::string field, std::string message) {
  if (full()) return;
  for (std::size_t i = 0; i < problems_.size(); ++i) {
    const bool told_already = i < given_ && !problems_[i].field.empty() && is_within(field, problems_[i].field);
    if (told_already || (problems_[i].field == field && problems_[i].message == message)) return;
  }
  problems_.push_back({.field = std::move(field), .message = std::move(message), .file = {}});
}

bool Findings::any_within(std::string_view field) const {
  return std::ranges::any_of(problems_, [&](const Problem& problem) { return is_within(problem.field, field); });
}

std::string nearest_name(std::string_view name, const std::vector<std::string_view>& known) {
  if (name.empty() || name.size() > longest_compared_name) return {};
  const std::string lower = lower_case(name);
  std::string_view nearest;
  std::size_t smallest = 1 + name.size() / 4;
  for (const auto candidate : known) {
    const std::size_t distance = edit_distance(lower, lower_case(candidate));
    // A name of which every letter would have to change is not a slip.
    if (distance > smallest || distance >= candidate.size()) continue;
    if (distance < smallest || nearest.empty()) nearest = candidate;
    smallest = distance;
  }
  return std::string(nearest);
}

std::string nearest_hint(std::string_view name, const std::vector<std::string_view>& known) {
  const std::string nearest = nearest_name(name, known);
  return nearest.empty() ? std::string() : "; did you mean '" + nearest + "'?";
}

std::size_t first_unreadable(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text.substr(i));
    if (length == 0) return i;
    const bool white_space = text[i] == '\t' || text[i] == '\n' || text[i] == '\r';
    if (is_control(text.substr(i, length)) && !white_space) return i;
    i += length;
  }
  return std::string_view::npos;
}

std::string printable(std::string_view text) {
  constexpr std::size_t longest = 60;
  constexpr std::string_view hex_digits = "0123456789abcdef";
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (result.size() >= longest) return result + "...";
    const std::size_t length = utf8_length(text.substr(i));
    if (length == 0 || is_control(text.substr(i, length))) {
      const auto byte = static_cast<unsigned char>(text[i]);
      result += {'\\', 'x', hex_digits[byte >> 4], hex_digits[byte & 15]};
      ++i;
    } else {
      result += text.substr(i, length);
      i += length;
    }
  }
  return result;
}

}  // namespace lamprey::experiment
