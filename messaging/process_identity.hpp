#pragma once

#include <cstdint>
#include <string>

/// Who a process is to others.
namespace lamprey::messaging {

/// Random, from the system, and not 0: a name that no other process has. Throws std::system_error if there is none.
std::uint64_t random_id();

/// The host's name, or "unknown".
std::string host_name();

}  // namespace lamprey::messaging
