#include "messaging/process_identity.hpp"

#include <array>
#include <cerrno>
#include <sys/random.h>
#include <system_error>
#include <unistd.h>

namespace lamprey::messaging {

std::uint64_t random_id() {
  std::uint64_t id = 0;
  while (id == 0) {
    const auto size = ::getrandom(&id, sizeof id, 0);
    if (size == static_cast<ssize_t>(sizeof id)) continue;
    id = 0;
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "getrandom");
  }
  return id;
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

}  // namespace lamprey::messaging
