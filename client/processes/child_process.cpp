#include "client/processes/child_process.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <linux/close_range.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace lamprey::client::processes {

namespace {

constexpr std::size_t longest_line = 64 * 1024;

struct Pipe {
  std::array<int, 2> ends{-1, -1};

  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reading() const { return ends[0]; }
  int writing() const { return ends[1]; }
  void close_end(std::size_t end) {
    if (ends[end] >= 0) ::close(ends[end]);
    ends[end] = -1;
  }
  int release_reading() {
    const int end = ends[0];
    ends[0] = -1;
    return end;
  }
};

/// A file in memory with the text, at its beginning: a pipe would block this program if the child read slowly.
int open_input(const std::string& text) {
  const int file = ::memfd_create("input", MFD_CLOEXEC);
  std::size_t written = 0;
  while (file >= 0 && written < text.size()) {
    const ssize_t size = ::write(file, text.data() + written, text.size() - written);
    if (size < 0 && errno != EINTR) break;
    if (size > 0) written += static_cast<std::size_t>(size);
  }
  if (file < 0 || written < text.size() || ::lseek(file, 0, SEEK_SET) != 0) {
    const int error = errno;
    if (file >= 0) ::close(file);
    throw std::system_error(error, std::generic_category(), "input of a child process");
  }
  return file;
}

/// In the child, between fork and exec: only async-signal-safe calls, since other threads may have held any lock.
/// Comes back with errno set if something failed.
void become(char* const* arguments, pid_t parent, int input, int output) {
  if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) return;
  if (::getppid() != parent) ::_exit(0);  // it died before the kernel had been told to watch it
  if (::setpgid(0, 0) != 0) return;
  if (::dup2(input, STDIN_FILENO) < 0) return;
  if (::dup2(output, STDOUT_FILENO) < 0 || ::dup2(output, STDERR_FILENO) < 0) return;
  // Sockets of this program's DDS participant must not live on in the child: it would hold their ports.
  if (::close_range(STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC) != 0) return;
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::signal(SIGPIPE, SIG_DFL);
  ::execv(arguments[0], arguments);
}

}  // namespace

std::string Exit::text() const {
  if (signal == 0) return "ended with exit code " + std::to_string(code);
  return "was killed by signal " + std::to_string(signal) + " (" + ::strsignal(signal) + ")";
}

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           const std::string& input) {
  std::vector<std::string> texts{program.string()};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (auto& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  Pipe output;
  Pipe failure;  // closed by a successful exec
  const int input_file = open_input(input);
  const pid_t parent = ::getpid();
  process_ = ::fork();
  const int fork_error = errno;
  if (process_ != 0) ::close(input_file);
  if (process_ < 0) throw std::system_error(fork_error, std::generic_category(), "fork");
  if (process_ == 0) {
    become(pointers.data(), parent, input_file, output.writing());
    const int error = errno;
    [[maybe_unused]] const auto written = ::write(failure.writing(), &error, sizeof error);
    ::_exit(127);
  }
  failure.close_end(1);
  int error = 0;
  ssize_t size = 0;
  while ((size = ::read(failure.reading(), &error, sizeof error)) < 0 && errno == EINTR) continue;
  if (size == static_cast<ssize_t>(sizeof error)) {
    ::waitpid(process_, nullptr, 0);
    throw std::system_error(error, std::generic_category(), "cannot start " + program.string());
  }
  output_ = output.release_reading();
  ::fcntl(output_, F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() {
  if (!poll()) {
    send(SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  ::close(output_);
}

std::optional<Exit> ChildProcess::poll() {
  int status = 0;
  if (!exit_ && ::waitpid(process_, &status, WNOHANG) == process_) {
    exit_ = WIFSIGNALED(status) ? Exit{.code = 0, .signal = WTERMSIG(status)} : Exit{.code = WEXITSTATUS(status)};
  }
  return exit_;
}

std::vector<std::string> ChildProcess::take_lines() {
  std::vector<std::string> lines;
  const bool ended = poll().has_value();
  const auto finish_line = [&] {
    lines.push_back(std::move(unfinished_));
    unfinished_.clear();
  };
  std::array<char, 4096> buffer{};
  ssize_t size = 0;
  while ((size = ::read(output_, buffer.data(), buffer.size())) > 0) {
    for (ssize_t i = 0; i < size; ++i) {
      const char character = buffer[static_cast<std::size_t>(i)];
      if (character != '\n') unfinished_ += character;
      if (character == '\n' || unfinished_.size() >= longest_line) finish_line();
    }
  }
  if (ended && !unfinished_.empty()) finish_line();
  return lines;
}

void ChildProcess::send(int signal) {
  if (!poll()) ::kill(-process_, signal);
}

}  // namespace lamprey::client::processes
