#include "client/output/live_screen.hpp"

#include "client/output/formatting.hpp"

#include <algorithm>

namespace lamprey::client::output {

void LiveScreen::draw(const std::vector<std::string>& lines, TerminalSize size) {
  // The cursor stands in the line below, and the last column stays free: some terminals wrap as soon as it is written.
  const std::size_t room = size.rows - std::min<std::size_t>(size.rows, 1);
  const std::size_t shown = std::min(lines.size(), room);
  // A terminal that has become smaller has pushed the upper lines out: they cannot be reached.
  const std::size_t up = std::min(drawn_, room);
  std::string text;
  if (up > 0) text += "\x1b[" + std::to_string(up) + "A";
  text += '\r';
  for (std::size_t i = 0; i < shown; ++i) {
    text += cut(lines[i], size.columns - std::min<std::size_t>(size.columns, 1), console_.ellipsis()) + "\x1b[K\n";
  }
  console_.out << text << "\x1b[J" << std::flush;
  drawn_ = shown;
}

}  // namespace lamprey::client::output
