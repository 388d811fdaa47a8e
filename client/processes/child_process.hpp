#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace lamprey::client::processes {

/// How a process ended.
struct Exit {
  int code = 0;    ///< if no signal ended it
  int signal = 0;  ///< that ended it; 0 if none did

  /// "ended with exit code 3", "was killed by signal 9 (Killed)".
  std::string text() const;
};

/// A program that runs as long as this one at most: the kernel kills it when the thread that started it dies, however
/// it dies. It has a process group of its own, so that the terminal's Ctrl-C reaches only this program, none of this
/// program's files, for input the text given, and its standard output and error both go here, line by line. One thread.
class ChildProcess {
 public:
  /// Throws std::system_error naming the program if it cannot be started.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               const std::string& input = {});
  /// Kills what still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t process() const { return process_; }

  /// How it ended, once it has; never blocks.
  std::optional<Exit> poll();

  /// The lines that it has written since the last call; after its end also an unfinished one. Never blocks.
  std::vector<std::string> take_lines();

  /// To its whole group, if it still runs.
  void send(int signal);

 private:
  pid_t process_ = -1;
  int output_ = -1;
  std::string unfinished_;
  std::optional<Exit> exit_;
};

}  // namespace lamprey::client::processes
