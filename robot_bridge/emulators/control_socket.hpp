#pragma once

#include "robot_bridge/emulators/descriptor.hpp"

#include <functional>
#include <poll.h>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::robot_bridge::emulators {

/// Lines in, one line each back: from a Unix socket that any number may connect to, or, at "-", from standard input and
/// to standard output.
class ControlSocket {
 public:
  /// Listens at `path`; a socket that nobody listens at any more is replaced. Throws std::invalid_argument if something
  /// else is there, std::system_error if the system refuses.
  explicit ControlSocket(std::string path);
  ~ControlSocket();
  ControlSocket(const ControlSocket&) = delete;
  ControlSocket& operator=(const ControlSocket&) = delete;

  /// Adds what there is to wait for.
  void watch(std::vector<pollfd>& watched) const;

  /// Reads what has come, which `watched` tells, and writes what `answer` says to each line, with a line break.
  void serve(const std::vector<pollfd>& watched, const std::function<std::string(std::string_view)>& answer);

 private:
  struct Connection {
    Descriptor owned;
    int in;
    int out;
    std::string received;
    bool open = true;
  };
  void accept_one();
  static void read_some(Connection& connection, const std::function<std::string(std::string_view)>& answer);

  std::string path_;
  Descriptor listener_;
  std::vector<Connection> connections_;
};

}  // namespace lamprey::robot_bridge::emulators
