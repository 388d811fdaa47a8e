#include "client/output/console.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <sys/ioctl.h>
#include <unistd.h>

namespace lamprey::client::output {

namespace {

constexpr std::size_t assumed_columns = 100;
constexpr std::size_t assumed_rows = 40;
constexpr std::size_t least_columns = 60;
constexpr std::size_t least_rows = 10;

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// As setlocale decides which variable counts; the tool itself stays in the C locale.
bool locale_is_utf8() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    std::string value(variable(name));
    if (value.empty()) continue;
    std::ranges::transform(value, value.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return value.find("utf-8") != std::string::npos || value.find("utf8") != std::string::npos;
  }
  return false;
}

}  // namespace

TerminalSize terminal_size() {
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
    winsize size{};
    if (::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
      return {.columns = std::max<std::size_t>(size.ws_col, least_columns),
              .rows = std::max<std::size_t>(size.ws_row, least_rows)};
    }
  }
  return {.columns = assumed_columns, .rows = assumed_rows};
}

Console system_console() {
  const auto size = terminal_size();
  return {.out = std::cout,
          .err = std::cerr,
          .out_is_terminal = ::isatty(STDOUT_FILENO) == 1,
          .err_is_terminal = ::isatty(STDERR_FILENO) == 1,
          .colour = variable("NO_COLOR").empty() && variable("TERM") != "dumb",
          .unicode = locale_is_utf8(),
          .columns = size.columns,
          .rows = size.rows};
}

}  // namespace lamprey::client::output
