#pragma once

#include "client/command.hpp"

#include <CLI/CLI.hpp>

namespace lamprey::client {

/// What `lamprey` and `lamprey --help` print: all commands by group, and examples.
void print_overview(const output::Console& console);

/// What `lamprey COMMAND --help` prints: usage, description, arguments, options, and the app's footer.
void print_help(const output::Console& console, const Command& command, const CLI::App& app);

/// What `lamprey --version` prints.
void print_version(const output::Console& console);

}  // namespace lamprey::client
