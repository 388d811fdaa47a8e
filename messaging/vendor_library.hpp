#pragma once

#include "messaging/port.hpp"

#include <string>
#include <vector>

/// What a vendor's library (liblamprey_messaging_<vendor>.so) exports; join() looks it up by name.
extern "C" {

/// A participant that the caller deletes; or nullptr, with the reason in `error`. Throws nothing. The library must stay
/// loaded for the rest of the process: the vendors' own threads and thread-local data do not survive unloading.
[[gnu::visibility("default")]] lamprey::messaging::Participant* lamprey_messaging_join(
    const lamprey::messaging::JoinOptions& options, std::string& error) noexcept;
}

namespace lamprey::messaging {

using JoinFunction = Participant* (*)(const JoinOptions&, std::string&) noexcept;
inline constexpr const char* join_function_name = "lamprey_messaging_join";
inline constexpr const char* vendor_library_prefix = "liblamprey_messaging_";

/// The vendors whose libraries are next to the program or in ../lib, sorted.
std::vector<std::string> available_vendors();

}  // namespace lamprey::messaging
