#pragma once

#include "messaging/program/logging.hpp"

#include <CLI/CLI.hpp>
#include <functional>

namespace lamprey::messaging::program {

/// What main() of a program that stays does once its options are declared: reads the command line, starts logging in
/// the app's name, and serves. Returns what `serve` returns; what it throws is told, and decides the exit code:
/// CLI::ParseError (of the command line, or of `serve` itself) exit_usage, JoinError exit_unreachable, others
/// exit_failure.
int run(CLI::App& app, int count, char** arguments, const LoggingOptions& logging, const std::function<int()>& serve);

}  // namespace lamprey::messaging::program
