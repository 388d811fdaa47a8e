#pragma once

#include "messaging/port.hpp"
#include "robot_bridge/calibration.hpp"
#include "robot_bridge/claims.hpp"
#include "robot_bridge/driver.hpp"
#include "robot_bridge/histogram.hpp"
#include "robot_bridge/setpoint_limiter.hpp"
#include "robot_bridge/step_rhythm.hpp"
#include "robot_bridge/step_timings.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace lamprey::robot_bridge {

using messaging::RobotState;

struct ControlOptions {
  double rate = 50;                               ///< time steps per second
  std::chrono::milliseconds off_after{10'000};    ///< servos that nobody needs are turned off after so long
  std::chrono::milliseconds retry_interval{500};  ///< from one try to reach the device to the next
};

/// One time step that the servos are to make.
struct StepOrder {
  std::uint64_t evaluation = 0;
  std::uint32_t time_step = 0;
  Pose target{};
  Clock::time_point arrived{};
};

/// What has come of an order.
struct StepReport {
  StepOrder order;
  bool done = false;  ///< else the device failed, for `reason`
  std::string reason;
  Pose commanded{};
  Feedback feedback{};
  std::chrono::nanoseconds command_to_line{0};
  std::chrono::nanoseconds line_to_state{0};
};

/// What the control loop tells when it is asked; a value.
struct ControlStatus {
  RobotState state = RobotState::unconfigured;
  std::string reason;      ///< why it is not active, where there is a reason
  std::string device;      ///< what the driver has found
  std::string scheduling;  ///< class and priority that the system has granted
  bool servos_off = true;  ///< the device has confirmed it, or has not been told to turn them on
  std::uint64_t orders_done = 0;
  std::uint64_t steps = 0;
  std::uint64_t late_steps = 0;  ///< began later than a period after the one before
  std::uint64_t late_moves = 0;  ///< were not over when the device was asked where its servos are
  std::uint64_t device_errors = 0;
  std::uint64_t clamped = 0;
  std::uint64_t slowed = 0;
  Histogram command_to_line;
  Histogram line_to_state;
  Histogram jitter;  ///< of the beginnings of steps, against their period
};

/// Where the device last said that the servos are.
struct PoseReading {
  Pose position{};
  bool measured = false;  ///< by sensors; else the device interpolates its commands
  Clock::time_point at{};
  std::uint64_t number = 0;  ///< higher than that of every reading before
};

/// The thread that alone talks to the servo controller: whatever the line does, nobody else waits for it. It keeps the
/// device connected, and moves the servos step by step within their limits. All members but the constructor and the
/// destructor return at once, from any thread. `signal` is notified of every change and report.
class ControlLoop {
 public:
  ControlLoop(std::unique_ptr<Driver> driver, const Calibration& calibration, const ControlOptions& options,
              std::shared_ptr<messaging::Signal> signal);
  /// Turns the servos off, if the line lets it, and ends the thread.
  ~ControlLoop();
  ControlLoop(const ControlLoop&) = delete;
  ControlLoop& operator=(const ControlLoop&) = delete;

  /// Servos on where they are, or, `confirmed`, in the standing pose where the device can't tell. They stay wanted on
  /// until deactivate() or stop(), over failures of the device.
  /// Each returns a number; ControlStatus::orders_done is at least that when the order has been carried out, or has
  /// failed.
  std::uint64_t activate(bool confirmed);
  std::uint64_t deactivate();

  /// Servos off as soon as the line has done what it is at. Where the device doesn't answer it is told nevertheless,
  /// again and again until it confirms; where it can't be reached, as soon as it can. Forgets all orders.
  std::uint64_t stop();

  /// To the pose at the slew rate, step by step. Replaces an order that has not begun.
  std::uint64_t place(const Pose& pose);
  void order(const StepOrder& step);
  /// Ends a placing that is under way: the servos stay where its last step has brought them.
  void halt();

  /// As place(), for somebody who has no claim: only while the servos are on and are to stay so, and no order but
  /// another place has still to begin. Whether it was taken.
  [[nodiscard]] bool place_if_free(const Pose& pose);

  /// Somebody needs the servos on.
  void keep_on(Clock::time_point now);

  /// Reports since the last call, in order.
  std::vector<StepReport> take_reports();
  ControlStatus status() const;
  /// Nothing while the device doesn't answer, or can't tell.
  std::optional<PoseReading> reading() const;
  StepTimings timings() const;

 private:
  struct Orders {
    std::uint64_t number = 0;  ///< of the newest that it has had
    bool stop = false;
    bool deactivate = false;
    bool halt = false;
    std::optional<bool> activate{};  ///< confirmed or not
    std::optional<Pose> place{};
    std::optional<StepOrder> step{};
  };

  void run(const std::stop_token& stop);
  void serve(const std::stop_token& stop);
  void obey(const Orders& orders);
  void turn_on(bool confirmed);
  void turn_off(const std::string& reason);
  void let_go_where_due();
  void cancel_where_away();
  bool undisturbed_until(Clock::time_point time);
  void give_up(StepReport result);
  void make_step(const StepOrder& order);
  std::optional<Feedback> feedback_when_arrived();
  void count_late_move();
  void place_step();
  void idle();
  void fail(const DriverError& error);
  void settle();
  std::uint64_t given(Orders orders);
  Orders wait_for_orders(const std::stop_token& stop, Clock::time_point until);
  Clock::time_point next_wake() const;
  void enter(RobotState state, const std::string& reason);
  void report(StepReport report);
  void note(const Feedback& feedback);
  void note(const std::optional<Pose>& position, bool measured);

  std::unique_ptr<Driver> driver_;
  ControlOptions options_;
  StepRhythm rhythm_;
  std::shared_ptr<messaging::Signal> signal_;

  // Of the thread.
  SetpointLimiter limiter_;
  bool on_ = false;
  bool may_be_on_ = false;      ///< was on, and the device has not confirmed yet that it isn't any more
  bool release_due_ = false;    ///< the servos are to be off, and the device has not confirmed it yet
  std::string release_reason_;  ///< of the release that is due, or was the last
  Clock::time_point failed_{};  ///< when the device last failed while its servos were on, or were turned on
  std::optional<Pose> placing_;
  std::uint64_t taken_ = 0;  ///< the number of the orders taken last
  Clock::time_point next_step_{};
  Clock::time_point last_contact_{};

  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  Orders orders_;
  std::uint64_t orders_given_ = 0;
  ControlStatus status_;
  StepTimings timings_;
  std::vector<StepReport> reports_;
  std::optional<PoseReading> reading_;
  std::uint64_t readings_ = 0;
  bool wanted_on_ = false;
  Clock::time_point needed_until_{};

  std::jthread thread_;  ///< last: it uses all of the above
};

}  // namespace lamprey::robot_bridge
