#pragma once

#include <cstdint>

/// UDP ports of this machine, asked for before Fast DDS takes them: it takes another one where it cannot have the one
/// that it is told, and does not say so.
namespace lamprey::messaging::fastdds {

/// Throws std::runtime_error with the system's reason unless a program could have that port on every address now.
void require_free(std::uint16_t port);

/// One that nobody has now, of those that the system gives to whoever asks for any. Throws std::runtime_error.
std::uint16_t any_free_port();

}  // namespace lamprey::messaging::fastdds
