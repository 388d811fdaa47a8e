#pragma once

#include "client/processes/child_process.hpp"
#include "client/processes/restart_policy.hpp"
#include "messaging/port.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamprey::client::processes {

using Clock = std::chrono::steady_clock;

struct FleetOptions {
  std::filesystem::path program_folder;  ///< where lamprey-coordinator and lamprey-worker are
  std::string database;
  std::uint32_t workers = 1;
  std::uint32_t threads = 1;  ///< of each worker
  messaging::JoinOptions join;
  std::vector<std::string> worker_vendors;  ///< taken in turn; empty: the coordinator's
  std::string log_level = "warn";
  std::string bridge;            ///< the robot that the workers are to have; empty: none
  std::string bridge_isolation;  ///< where its bridge is
};

/// A coordinator and its workers as processes of this machine. What dies is started again a few times; what they log
/// is passed on. They don't outlive this object. One thread, which must live as long.
class Fleet {
 public:
  /// Starts them. `say` gets a line for the user now and then. Throws Failure if a program is missing or can't be
  /// started.
  Fleet(FleetOptions options, std::function<void(const std::string&)> say);
  ~Fleet() { stop(); }
  Fleet(const Fleet&) = delete;
  Fleet& operator=(const Fleet&) = delete;

  /// Looks after all of them. Throws Failure when there is no going on: with the coordinator's own message and exit
  /// code if it has ended with one, or if no worker is left.
  void step(Clock::time_point now);

  /// Lets the workers hand in what they have and leave, then the coordinator store it and end; kills whoever is not
  /// gone after 1.5 s. Again: nothing.
  void stop() noexcept;

 private:
  struct Member {
    std::string name;
    std::filesystem::path program;
    std::vector<std::string> arguments;
    std::unique_ptr<ChildProcess> process;  ///< empty while it waits for its restart, or for good
    RestartPolicy policy;
    Clock::time_point started;
    std::optional<Clock::time_point> restart_at;
  };
  /// A line of the coordinator that may yet turn out to be why it ended.
  struct HeldLine {
    Clock::time_point time;
    std::string text;
  };

  Member make_worker(std::uint32_t number) const;
  void start(Member& member, Clock::time_point now);
  void pass_on_lines(Clock::time_point now);
  void look_after(Member& member, Clock::time_point now);
  void release_lines(Clock::time_point until);
  [[noreturn]] void coordinator_failed(const Exit& exit);
  bool wait_for_workers(Clock::time_point until);

  FleetOptions options_;
  std::function<void(const std::string&)> say_;
  Member coordinator_;
  std::vector<Member> workers_;
  std::deque<HeldLine> coordinator_lines_;
  std::string last_worker_end_;
};

}  // namespace lamprey::client::processes
