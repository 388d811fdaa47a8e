#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace lamprey::robot_bridge::drivers {

/// A device at the other end of a pseudo-terminal, whose answers the test decides on.
class PseudoTerminal {
 public:
  /// Takes what it understands away from the front of what has come, and returns the answer to it.
  using Answer = std::function<std::string(std::string& received)>;

  /// Without an answer the device is silent.
  explicit PseudoTerminal(Answer answer = {});
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// The path for a driver.
  const std::string& port() const { return port_; }

  /// Sends what nobody asked for.
  void send(const std::string& octets);

  /// All that has come.
  std::string received() const;

  /// Pulls the plug.
  void unplug();

 private:
  void serve();

  Answer answer_;
  std::string port_;
  int device_ = -1;
  int kept_open_ = -1;  ///< so that the terminal outlives drivers that close it
  int wake_[2] = {-1, -1};
  mutable std::mutex mutex_;
  std::string received_;
  std::thread thread_;
};

}  // namespace lamprey::robot_bridge::drivers
