#pragma once

#include "robot_bridge/calibration.hpp"
#include "robot_bridge/driver.hpp"
#include "robot_bridge/drivers/sent_position.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

namespace lamprey::robot_bridge::drivers {

/// What goes wrong in calls of a mock.
struct MockFault {
  std::chrono::milliseconds delay{0};  ///< before the call does anything
  std::optional<DriverError::Kind> error =
      std::nullopt;  ///< then it fails so; `silent` only after the deadline that devices have
  int calls = 1;     ///< how many calls it is met by, one after the other; −1: all
};

/// The simulator's quadruped behind the interface of a device: moves are instant and measured exactly. Faults, and what
/// has become of the robot, may be set and asked for from any thread.
class MockDriver final : public Driver {
 public:
  explicit MockDriver(const Calibration& calibration);

  void connect() override;
  std::optional<Pose> present_position() override;
  void enable(const Pose& start) override;
  void move(const Pose& target, std::chrono::microseconds duration) override;
  Feedback read() override;
  bool moving() override;
  void hold() override;
  void release() override;
  bool let_go() noexcept override;
  void cancel() noexcept override;
  std::string description() const override;
  double highest_rate() const override;

  /// Instead of the fault before.
  void inject(MockFault fault);
  /// The next move begins to be carried out only when moving() has been asked so often.
  void delay_next_move(int questions);
  /// Puts the legs somewhere, as a hand would.
  void put(const Pose& position);

  Pose position() const;
  bool is_connected() const;
  bool is_enabled() const;
  /// Moves since the mock was made.
  std::uint64_t moves() const;

 private:
  enum class Needs : bool { nothing, connection };

  /// Runs one call of the interface under the lock, after the fault's part.
  template <typename Body>
  auto call(Needs needs, const Body& body);
  void meet_fault(std::unique_lock<std::mutex>& lock);
  void wait(std::unique_lock<std::mutex>& lock, std::chrono::milliseconds duration);
  /// The position that a servo reaches.
  Pose reached(const Pose& target) const;

  const Calibration calibration_;
  mutable std::mutex mutex_;
  std::condition_variable cancelled_changed_;
  bool cancelled_ = false;
  std::optional<MockFault> fault_;
  bool connected_ = false;
  bool enabled_ = false;
  Pose position_ = standing_pose();
  Pose goal_ = standing_pose();
  int delay_ = 0;
  std::uint64_t moves_ = 0;
};

}  // namespace lamprey::robot_bridge::drivers
