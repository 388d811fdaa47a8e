#pragma once

#include "messaging/port.hpp"
#include "robot_bridge/claims.hpp"
#include "robot_bridge/command_gate.hpp"
#include "robot_bridge/control_loop.hpp"
#include "robot_bridge/request_door.hpp"
#include "robot_bridge/state_file.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamprey::robot_bridge {

struct BridgeOptions {
  std::string robot;  ///< its name
  std::string driver;
  double rate = 50;
  std::chrono::milliseconds claim_lease{2000};
  /// A command may come so long after the state of the step before it; then its evaluation is void.
  std::chrono::milliseconds grace{200};
  /// A further way in, for the emergency stop alone; nullptr: none. Must outlive the bridge.
  messaging::Participant* emergency = nullptr;
  std::uint64_t incarnation = 0;
  std::string host;
  std::uint32_t process = 0;
  std::string build;
  /// Called with each state that is published; returns at once. May be empty.
  std::function<void(const messaging::ServoState&)> on_state = {};
};

/// A robot on the DDS domain: answers requests, grants the claim, lets the claim's commands through to the control loop
/// and publishes what has come of them. step() never waits for the device. One thread; times are those given.
class Bridge {
 public:
  Bridge(messaging::Participant& participant, std::shared_ptr<messaging::Signal> signal, ControlLoop& control,
         StateFile& file, const BridgeOptions& options, Clock::time_point now);

  void step(Clock::time_point now);

  /// Tells everybody that the robot is gone.
  void finish();

  bool stopped() const { return file_.state().stopped; }

  /// Whether somebody's claim is in force.
  bool claimed(Clock::time_point now) const { return claims_.in_force(now); }

  /// Why the robot can't be moved, as of the last step; empty if it can.
  std::string hindrance() const;

  /// What it has counted, by name: commands refused, evaluations voided, limits that have acted, latencies.
  std::vector<messaging::RobotCounter> counters() const;

 private:
  using Request = messaging::RobotRequest;
  using Reply = messaging::RobotReply;

  /// A request whose answer waits for the control loop.
  struct Pending {
    RequestDoor* door;
    Request request;
    std::uint64_t order;
    Clock::time_point until;
  };

  void take_requests(Clock::time_point now);
  void take_commands(Clock::time_point now);
  void take_reports(Clock::time_point now);
  void answer_pending(Clock::time_point now);
  void look_after_evaluation(Clock::time_point now);
  void publish_status(Clock::time_point now);

  void look_at(RequestDoor& door, const Request& request, Clock::time_point now);
  void handle(RequestDoor& door, const Request& request, Clock::time_point now);
  void claim(const Request& request, Clock::time_point now);
  void stop(RequestDoor& door, const Request& request, Clock::time_point now);
  void reset(const Request& request);
  void place(const Request& request, Clock::time_point now);
  Reply reply_to(const Request& request, bool granted, const std::string& reason) const;
  void send(Reply reply) { send(requests_, std::move(reply)); }
  void send(RequestDoor& door, Reply reply);
  void publish(const messaging::ServoState& state);
  void void_evaluation(const std::string& reason);
  void latch(const std::string& reason);
  /// Whether the state is on the disk; else it says so in the log.
  bool store(const StoredState& state);

  std::shared_ptr<messaging::Signal> signal_;
  ControlLoop& control_;
  StateFile& file_;
  BridgeOptions options_;
  std::uint64_t robot_;
  Claims claims_;
  CommandGate gate_;
  ControlStatus control_status_;

  RequestDoor requests_;
  std::optional<RequestDoor> emergency_;
  std::unique_ptr<messaging::Reader<messaging::ServoCommand>> commands_;
  std::unique_ptr<messaging::Writer<messaging::ServoState>> states_;
  std::unique_ptr<messaging::Writer<messaging::RobotStatus>> statuses_;
  messaging::Participant& participant_;
  std::vector<Pending> pending_;

  messaging::RobotStatus last_status_;
  Clock::time_point status_due_{};
  std::uint64_t requests_refused_ = 0;
  std::uint64_t other_robots_ = 0;
  bool stop_is_stored_ = true;
};

}  // namespace lamprey::robot_bridge
