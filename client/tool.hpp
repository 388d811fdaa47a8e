#pragma once

#include "client/command.hpp"

#include <string>
#include <vector>

namespace lamprey::client {

/// The whole tool behind main(): reads the command line (without the program's name), does what it says, writes what
/// went wrong. Never throws.
ExitCode run_tool(const std::vector<std::string>& arguments, const output::Console& console,
                  const Environment& environment);

}  // namespace lamprey::client
