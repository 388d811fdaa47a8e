#include "robot_bridge/emulators/control_socket.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <system_error>
#include <utility>

namespace lamprey::robot_bridge::emulators {
namespace {

constexpr std::string_view standard_input_and_output = "-";
constexpr std::size_t longest_line = 4096;
constexpr int backlog = 8;

[[noreturn]] void fail(const std::string& path) {
  throw std::system_error(errno, std::generic_category(), "control socket '" + path + "'");
}

sockaddr_un address_of(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) {
    throw std::invalid_argument("control socket '" + path + "': a path has 1.." +
                                std::to_string(sizeof address.sun_path - 1) + " octets");
  }
  std::memcpy(address.sun_path, path.data(), path.size());
  return address;
}

const sockaddr* generic(const sockaddr_un& address) {
  return reinterpret_cast<const sockaddr*>(&address);
}

/// Removes a socket that was left over.
void make_room(const std::string& path, const sockaddr_un& address) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return;
  if (!S_ISSOCK(status.st_mode)) throw std::invalid_argument("control socket '" + path + "': there is something else");
  const Descriptor trial(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (::connect(trial.get(), generic(address), sizeof address) == 0 || errno != ECONNREFUSED) {
    throw std::invalid_argument("control socket '" + path + "': somebody else listens there");
  }
  ::unlink(path.c_str());
}

/// An answer is short: who does not read it loses it.
void write_all(int out, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    auto count = ::send(out, text.data() + done, text.size() - done, MSG_NOSIGNAL);
    if (count < 0 && errno == ENOTSOCK) count = ::write(out, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    done += static_cast<std::size_t>(count);
  }
}

}  // namespace

ControlSocket::ControlSocket(std::string path) : path_(std::move(path)) {
  if (path_ == standard_input_and_output) {
    connections_.push_back({Descriptor(), STDIN_FILENO, STDOUT_FILENO, {}});
    return;
  }
  const sockaddr_un address = address_of(path_);
  make_room(path_, address);
  listener_ = Descriptor(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (listener_.get() < 0 || ::bind(listener_.get(), generic(address), sizeof address) != 0 ||
      ::listen(listener_.get(), backlog) != 0) {
    fail(path_);
  }
}

ControlSocket::~ControlSocket() {
  if (listener_.get() >= 0) ::unlink(path_.c_str());
}

void ControlSocket::watch(std::vector<pollfd>& watched) const {
  if (listener_.get() >= 0) watched.push_back({listener_.get(), POLLIN, 0});
  for (const Connection& connection : connections_) watched.push_back({connection.in, POLLIN, 0});
}

void ControlSocket::serve(const std::vector<pollfd>& watched,
                          const std::function<std::string(std::string_view)>& answer) {
  const auto ready = [&](int descriptor) {
    return std::ranges::any_of(watched, [&](const pollfd& one) { return one.fd == descriptor && one.revents != 0; });
  };
  for (Connection& connection : connections_) {
    if (ready(connection.in)) read_some(connection, answer);
  }
  std::erase_if(connections_, [](const Connection& connection) { return !connection.open; });
  if (listener_.get() >= 0 && ready(listener_.get())) accept_one();
}

void ControlSocket::accept_one() {
  Descriptor descriptor(::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC));
  if (descriptor.get() < 0) return;
  const int number = descriptor.get();
  // Whoever does not read the answers must not stop the line.
  const timeval patience{1, 0};
  ::setsockopt(number, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  connections_.push_back({std::move(descriptor), number, number, {}});
}

void ControlSocket::read_some(Connection& connection, const std::function<std::string(std::string_view)>& answer) {
  std::array<char, 1024> buffer{};
  const auto count = ::read(connection.in, buffer.data(), buffer.size());
  if (count < 0 && errno == EINTR) return;
  connection.received.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  for (auto end = connection.received.find('\n'); end != std::string::npos; end = connection.received.find('\n')) {
    write_all(connection.out, answer(std::string_view(connection.received).substr(0, end)) + "\n");
    connection.received.erase(0, end + 1);
  }
  if (count <= 0 || connection.received.size() > longest_line) connection.open = false;
}

}  // namespace lamprey::robot_bridge::emulators
