#include "tests/conformance/other_program.hpp"

#include "tests/conformance/world.hpp"

#include <array>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

extern char** environ;

namespace lamprey::messaging::conformance {

OtherProgram::OtherProgram(const JoinOptions& options, const std::vector<std::string>& arguments) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe2");
  output_ = ends[0];
  std::vector<std::string> words{LAMPREY_OTHER_PROGRAM, options.vendor, std::to_string(options.domain),
                                 options.isolation, "loopback"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const int error = posix_spawn(&process_, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (error != 0) throw std::runtime_error("cannot start " + words[0]);
}

OtherProgram::~OtherProgram() {
  kill();
  close(output_);
}

void OtherProgram::kill() {
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
  process_ = -1;
}

void OtherProgram::stop() {
  ::kill(process_, SIGSTOP);
  waitpid(process_, nullptr, WUNTRACED);
}

void OtherProgram::resume() {
  ::kill(process_, SIGCONT);
}

bool OtherProgram::listen_until(const std::function<bool(const std::vector<std::uint64_t>&)>& enough) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (!enough(said)) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    listen(std::chrono::milliseconds(50));
  }
  return true;
}

void OtherProgram::listen(std::chrono::milliseconds timeout) {
  pollfd poll_for{output_, POLLIN, 0};
  if (poll(&poll_for, 1, static_cast<int>(timeout.count())) != 1) return;
  std::array<char, 4096> buffer{};
  const auto size = read(output_, buffer.data(), buffer.size());
  if (size <= 0) throw std::runtime_error("the other program has ended");
  rest_.append(buffer.data(), static_cast<std::size_t>(size));
  std::size_t begin = 0;
  for (auto end = rest_.find('\n'); end != std::string::npos; end = rest_.find('\n', begin)) {
    said.push_back(std::stoull(rest_.substr(begin, end - begin)));
    begin = end + 1;
  }
  rest_.erase(0, begin);
}

}  // namespace lamprey::messaging::conformance
