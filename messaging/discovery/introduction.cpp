#include "messaging/discovery/introduction.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace lamprey::messaging::discovery {
namespace {

constexpr std::string_view prefix = "lamprey;";
constexpr std::size_t longest_value = 128;
constexpr std::size_t longest_introduction = 1024;

bool is_plain(char character) {
  return character >= ' ' && character <= '~' && character != ';';
}

std::string plain(std::string_view text) {
  std::string result(text.substr(0, longest_value));
  std::ranges::replace_if(
      result, [](char character) { return !is_plain(character); }, '_');
  return result;
}

bool read_number(std::string_view text, std::uint32_t& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

/// False where the value can't be one of that field; a field that is not known here is a newer program's.
bool read_field(std::string_view name, std::string_view value, Introduction& introduction) {
  if (value.size() > longest_value || !std::ranges::all_of(value, is_plain)) return false;
  if (name == "role") introduction.role = value;
  if (name == "host") introduction.host = value;
  if (name == "build") introduction.build = value;
  if (name == "isolation") introduction.isolation = value;
  if (name == "process") return read_number(value, introduction.process);
  if (name == "wire") return read_number(value, introduction.wire);
  return true;
}

}  // namespace

std::string user_data_of(const Introduction& introduction) {
  return std::string(prefix) + "wire=" + std::to_string(introduction.wire) + ";role=" + plain(introduction.role) +
         ";host=" + plain(introduction.host) + ";process=" + std::to_string(introduction.process) +
         ";isolation=" + plain(introduction.isolation) + ";build=" + plain(introduction.build);
}

std::optional<Introduction> introduction_in(std::string_view user_data) {
  if (!user_data.starts_with(prefix) || user_data.size() > longest_introduction) return std::nullopt;
  user_data.remove_prefix(prefix.size());
  Introduction introduction;
  while (!user_data.empty()) {
    const std::string_view field = user_data.substr(0, user_data.find(';'));
    user_data.remove_prefix(std::min(field.size() + 1, user_data.size()));
    const auto separator = field.find('=');
    if (separator == std::string_view::npos) return std::nullopt;
    if (!read_field(field.substr(0, separator), field.substr(separator + 1), introduction)) return std::nullopt;
  }
  return introduction;
}

}  // namespace lamprey::messaging::discovery
