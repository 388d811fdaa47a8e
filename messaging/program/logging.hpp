#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <ostream>
#include <spdlog/formatter.h>
#include <string>

namespace lamprey::messaging::program {

struct LoggingOptions {
  std::string level = "info";   ///< trace, debug, info, warn, error, off
  std::string format = "text";  ///< text or json
};

/// Adds --log-level and --log-format; parsing fills `options`, which must outlive the app.
void add_logging_options(CLI::App& app, LoggingOptions& options);

/// From now on spdlog's functions write to standard error, one line per event, and what protobuf has to say (at level
/// debug) with them. Once per process, in main.
///   text:  2026-01-31T12:00:00.123Z info lamprey-worker: message
///   json:  {"time":"2026-01-31T12:00:00.123Z","level":"info","program":"lamprey-worker","message":"…"}
/// Line breaks within a message are written as \n, other control characters in text as ?; in JSON, octets that are not
/// UTF-8 are replaced.
void start_logging(const LoggingOptions& options, const std::string& program);

/// The formatter that start_logging installs.
std::unique_ptr<spdlog::formatter> make_formatter(const std::string& format, const std::string& program);

}  // namespace lamprey::messaging::program
