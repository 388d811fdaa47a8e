#include "client/tool.hpp"
#include "messaging/program/stop.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

int main(int count, char** arguments) {
  using namespace lamprey;
  try {
    const messaging::program::StopOnSignal stop(nullptr);
    const client::Environment environment{
        .join = [](const messaging::JoinOptions& options) { return messaging::join(options); },
        .interrupted = [&stop] { return stop.requested(); },
        .program_folder = std::filesystem::read_symlink("/proc/self/exe").parent_path()};
    return client::run_tool({arguments + std::min(count, 1), arguments + count}, client::output::system_console(),
                            environment);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lamprey: error: %s\n", error.what());
    return client::exit_failure;
  }
}
