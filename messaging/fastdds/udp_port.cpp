#include "messaging/fastdds/udp_port.hpp"

#include <arpa/inet.h>
#include <cerrno>
#include <netinet/in.h>
#include <stdexcept>
#include <string>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>

namespace lamprey::messaging::fastdds {
namespace {

/// Had for a moment; 0: any. The port that it was.
std::uint16_t taken_and_left(std::uint16_t port) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(port);
  place.sin_addr.s_addr = htonl(INADDR_ANY);
  socklen_t size = sizeof place;
  auto* const generic = reinterpret_cast<sockaddr*>(&place);
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const bool had = socket >= 0 && ::bind(socket, generic, size) == 0 && ::getsockname(socket, generic, &size) == 0;
  const int error = errno;
  if (socket >= 0) ::close(socket);
  if (!had) throw std::system_error(error, std::generic_category());
  return ntohs(place.sin_port);
}

}  // namespace

void require_free(std::uint16_t port) {
  try {
    taken_and_left(port);
  } catch (const std::system_error& error) {
    throw std::runtime_error("UDP port " + std::to_string(port) +
                             " of a discovery server can't be had: " + error.code().message());
  }
}

std::uint16_t any_free_port() {
  try {
    return taken_and_left(0);
  } catch (const std::system_error& error) {
    throw std::runtime_error("no UDP port is free: " + error.code().message());
  }
}

}  // namespace lamprey::messaging::fastdds
