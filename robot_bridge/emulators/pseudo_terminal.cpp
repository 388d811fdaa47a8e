#include "robot_bridge/emulators/pseudo_terminal.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <pty.h>
#include <stdexcept>
#include <system_error>
#include <termios.h>
#include <utility>

namespace lamprey::robot_bridge::emulators {
namespace {

namespace filesystem = std::filesystem;

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

struct Speed {
  unsigned baud;
  speed_t name;
};
constexpr std::array speeds{Speed{9600, B9600},       Speed{19200, B19200},     Speed{38400, B38400},
                            Speed{57600, B57600},     Speed{115200, B115200},   Speed{230400, B230400},
                            Speed{500000, B500000},   Speed{1000000, B1000000}, Speed{2000000, B2000000},
                            Speed{3000000, B3000000}, Speed{4000000, B4000000}};

unsigned long speed_name(unsigned baud) {
  for (const Speed& speed : speeds) {
    if (speed.baud == baud) return speed.name;
  }
  return 0;
}

bool may_be_replaced(const filesystem::path& link) {
  const auto status = filesystem::symlink_status(link);
  if (!filesystem::exists(status)) return true;
  if (!filesystem::is_symlink(status)) return false;
  return !filesystem::exists(link) || filesystem::read_symlink(link).string().starts_with("/dev/pts/");
}

void make_link(const std::string& link, const std::string& target) {
  if (!may_be_replaced(link)) throw std::invalid_argument("'" + link + "' is there and no link to a pseudo-terminal");
  const std::string made = link + ".new";
  std::error_code error;
  filesystem::remove(made, error);
  filesystem::create_symlink(target, made, error);
  if (!error) filesystem::rename(made, link, error);
  if (error) throw std::invalid_argument("link '" + link + "': " + error.message());
}

}  // namespace

PseudoTerminal::PseudoTerminal(std::string link, unsigned baud) : link_(std::move(link)), speed_(speed_name(baud)) {
  termios settings{};
  ::cfmakeraw(&settings);
  settings.c_cflag |= CREAD | CLOCAL;
  if (speed_ != 0) ::cfsetspeed(&settings, static_cast<speed_t>(speed_));
  int master = -1;
  int slave = -1;
  std::array<char, 64> name{};
  if (::openpty(&master, &slave, name.data(), &settings, nullptr) != 0) fail("pseudo-terminal");
  master_ = Descriptor(master);
  slave_ = Descriptor(slave);
  slave_name_ = name.data();
  if (::fcntl(master, F_SETFL, O_NONBLOCK) != 0 || ::fcntl(master, F_SETFD, FD_CLOEXEC) != 0 ||
      ::fcntl(slave, F_SETFD, FD_CLOEXEC) != 0) {
    fail("pseudo-terminal");
  }
  make_link(link_, slave_name_);
}

PseudoTerminal::~PseudoTerminal() {
  std::error_code error;
  const auto target = filesystem::read_symlink(link_, error);
  if (!error && target == slave_name_) filesystem::remove(link_, error);
}

std::span<const std::uint8_t> PseudoTerminal::read(std::span<std::uint8_t> buffer) {
  const auto count = ::read(master_.get(), buffer.data(), buffer.size());
  if (count >= 0) return buffer.first(static_cast<std::size_t>(count));
  if (errno == EAGAIN || errno == EINTR) return {};
  fail("reading the pseudo-terminal");
}

std::size_t PseudoTerminal::write(std::span<const std::uint8_t> octets) {
  std::size_t done = 0;
  while (done < octets.size()) {
    const auto count = ::write(master_.get(), octets.data() + done, octets.size() - done);
    if (count > 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      break;
    }
  }
  return done;
}

bool PseudoTerminal::at_another_speed() const {
  termios settings{};
  if (speed_ == 0 || ::tcgetattr(slave_.get(), &settings) != 0) return false;
  return ::cfgetospeed(&settings) != speed_;
}

}  // namespace lamprey::robot_bridge::emulators
