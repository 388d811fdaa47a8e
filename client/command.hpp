#pragma once

#include "client/exit_code.hpp"
#include "client/output/console.hpp"
#include "messaging/discovery/watch.hpp"
#include "messaging/port.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::client {

/// `table` is what people read: a command whose answer is no table calls it text.
enum class Format : unsigned char { table, json, csv, html };

/// What a command needs of the outside; main makes it, tests make another.
struct Environment {
  std::function<std::unique_ptr<messaging::Participant>(const messaging::JoinOptions&)> join;
  std::function<std::unique_ptr<messaging::discovery::Watch>(const messaging::JoinOptions&)> watch;
  std::function<bool()> interrupted;     ///< whether the user wants the tool to end
  std::filesystem::path program_folder;  ///< where lamprey-coordinator and lamprey-worker are
};

struct Context {
  const output::Console& console;
  const Environment& environment;
  Format format = Format::table;
};

/// Does the work once the command line has been read. Throws Failure, experiment::InvalidInput, storage::StorageError.
using Action = std::function<ExitCode(const Context&)>;

/// One row per command: help, dispatch and "did you mean" derive from it. Adding a command is its file in commands/,
/// a row, its test and a line in CMake.
struct Command {
  std::string_view name;
  std::string_view group;                 ///< heading in the overview
  std::string_view summary;               ///< one line
  std::vector<std::string_view> formats;  ///< the first is the default
  /// Declares arguments and options on `app`; the answer is called after they have been read.
  Action (*declare)(CLI::App& app);
};

/// In the order of the overview.
std::span<const Command> command_table();

}  // namespace lamprey::client
