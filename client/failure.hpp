#pragma once

#include "client/exit_code.hpp"
#include "client/output/formatting.hpp"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace lamprey::client {

/// Why a command ended without doing what it was asked to do: for people the messages (a line each) and maybe details
/// under them, for programs a snake_case code and the exit code.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode exit_code, std::string code, std::vector<std::string> messages,
          std::vector<std::string> details = {})
      : std::runtime_error(output::joined(messages, "\n")),
        exit_code_(exit_code),
        code_(std::move(code)),
        messages_(std::move(messages)),
        details_(std::move(details)) {}
  Failure(ExitCode exit_code, std::string code, std::string message)
      : Failure(exit_code, std::move(code), std::vector{std::move(message)}) {}

  ExitCode exit_code() const { return exit_code_; }
  const std::string& code() const { return code_; }
  const std::vector<std::string>& messages() const { return messages_; }
  const std::vector<std::string>& details() const { return details_; }

 private:
  ExitCode exit_code_;
  std::string code_;
  std::vector<std::string> messages_;
  std::vector<std::string> details_;
};

/// The command line is wrong.
inline Failure usage_failure(std::string message) {
  return {exit_usage, "usage", std::move(message)};
}

}  // namespace lamprey::client
