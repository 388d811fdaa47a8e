#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>

namespace lamprey::client::output {

/// Where a command's words go, and what can be shown there. Results go to `out`; progress, hints and errors to `err`.
struct Console {
  std::ostream& out;
  std::ostream& err;
  bool out_is_terminal = false;
  bool err_is_terminal = false;
  bool colour = false;        ///< on whichever of the two is a terminal
  bool unicode = false;       ///< else rules, dashes and ellipses are ASCII
  std::size_t columns = 100;  ///< width of the terminal, or what is assumed without one
  std::size_t rows = 40;      ///< its height

  std::string_view ellipsis() const { return unicode ? "…" : "..."; }
  std::string_view dash() const { return unicode ? "–" : "-"; }

  /// The text in that style where `out` shows styles, else unchanged.
  std::string bold(std::string_view text) const { return styled(text, "\x1b[1m", out_is_terminal); }
  std::string dim(std::string_view text) const { return styled(text, "\x1b[2m", out_is_terminal); }
  std::string good(std::string_view text) const { return styled(text, "\x1b[32m", out_is_terminal); }
  std::string alert(std::string_view text) const { return styled(text, "\x1b[1;31m", out_is_terminal); }
  /// The same for `err`.
  std::string red(std::string_view text) const { return styled(text, "\x1b[1;31m", err_is_terminal); }
  std::string yellow(std::string_view text) const { return styled(text, "\x1b[33m", err_is_terminal); }

 private:
  std::string styled(std::string_view text, std::string_view begin, bool is_terminal) const {
    if (!colour || !is_terminal || text.empty()) return std::string(text);
    return std::string(begin) + std::string(text) + "\x1b[0m";
  }
};

/// The size of the terminal that the program writes to at this moment; that of a console without one if there is none.
struct TerminalSize {
  std::size_t columns;
  std::size_t rows;
};
TerminalSize terminal_size();

/// The program's own: terminals are found with isatty, colour is off where NO_COLOR is set or TERM is dumb, Unicode is
/// on where the locale's character set is UTF-8.
Console system_console();

}  // namespace lamprey::client::output
