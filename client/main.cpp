#include "client/tool.hpp"
#include "messaging/discovery/watch.hpp"
#include "messaging/program/join_options.hpp"
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
        .join =
            [](messaging::JoinOptions options) {
              options.introduction = messaging::program::introduction("client");
              return messaging::join(options);
            },
        .watch =
            [](messaging::JoinOptions options) {
              options.introduction = messaging::program::introduction("observer");
              return messaging::discovery::watch(options);
            },
        .interrupted = [&stop] { return stop.requested(); },
        .program_folder = std::filesystem::read_symlink("/proc/self/exe").parent_path()};
    return client::run_tool({arguments + std::min(count, 1), arguments + count}, client::output::system_console(),
                            environment);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lamprey: error: %s\n", error.what());
    return client::exit_failure;
  }
}
