#include "pseudo_terminal.hpp"

#include <array>
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <system_error>
#include <termios.h>
#include <unistd.h>
#include <utility>

namespace lamprey::robot_bridge::drivers {

namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::system_error(errno, std::generic_category(), what);
}

void write_all(int descriptor, const std::string& octets) {
  std::size_t written = 0;
  while (written < octets.size()) {
    const auto count = ::write(descriptor, octets.data() + written, octets.size() - written);
    if (count <= 0) return;
    written += static_cast<std::size_t>(count);
  }
}

}  // namespace

PseudoTerminal::PseudoTerminal(Answer answer) : answer_(std::move(answer)) {
  std::array<char, 128> name{};
  require(::openpty(&device_, &kept_open_, name.data(), nullptr, nullptr) == 0, "openpty");
  port_ = name.data();
  termios raw{};
  require(::tcgetattr(kept_open_, &raw) == 0, "tcgetattr");
  ::cfmakeraw(&raw);
  require(::tcsetattr(kept_open_, TCSANOW, &raw) == 0, "tcsetattr");
  require(::pipe2(wake_, O_CLOEXEC) == 0, "pipe2");
  thread_ = std::thread([this] { serve(); });
}

PseudoTerminal::~PseudoTerminal() {
  unplug();
}

void PseudoTerminal::send(const std::string& octets) {
  write_all(device_, octets);
}

std::string PseudoTerminal::received() const {
  const std::lock_guard lock(mutex_);
  return received_;
}

void PseudoTerminal::unplug() {
  if (!thread_.joinable()) return;
  write_all(wake_[1], "x");
  thread_.join();
  for (const int descriptor : {kept_open_, device_, wake_[0], wake_[1]}) ::close(descriptor);
}

void PseudoTerminal::serve() {
  std::string unanswered;
  while (true) {
    std::array<pollfd, 2> waited = {{{device_, POLLIN, 0}, {wake_[0], POLLIN, 0}}};
    if (::poll(waited.data(), waited.size(), -1) < 0) continue;
    if (waited[1].revents != 0) return;
    std::array<char, 256> octets{};
    const auto count = ::read(device_, octets.data(), octets.size());
    if (count <= 0) continue;
    const std::string come(octets.data(), static_cast<std::size_t>(count));
    {
      const std::lock_guard lock(mutex_);
      received_ += come;
    }
    unanswered += come;
    if (answer_) write_all(device_, answer_(unanswered));
  }
}

}  // namespace lamprey::robot_bridge::drivers
