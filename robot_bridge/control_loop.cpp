#include "robot_bridge/control_loop.hpp"

#include "messaging/robot/robot_state.hpp"
#include "robot_bridge/scheduling.hpp"

#include <algorithm>
#include <cmath>
#include <spdlog/spdlog.h>
#include <utility>

namespace lamprey::robot_bridge {
namespace {

using std::chrono::nanoseconds;

/// Servos that hold, and a device that moves nothing, are looked at so often.
constexpr std::chrono::milliseconds look_interval{100};

/// From one question whether servos have arrived to the next, and how long they are asked.
constexpr std::chrono::milliseconds arrival_interval{2};
constexpr std::chrono::milliseconds longest_arrival{1000};

double seconds(nanoseconds duration) {
  return std::chrono::duration<double>(duration).count();
}

bool same(const Pose& one, const Pose& other) {
  constexpr double rounding = 1e-9;
  return std::ranges::equal(one, other, [](double a, double b) { return std::abs(a - b) < rounding; });
}

}  // namespace

ControlLoop::ControlLoop(std::unique_ptr<Driver> driver, const Calibration& calibration, const ControlOptions& options,
                         std::shared_ptr<messaging::Signal> signal)
    : driver_(std::move(driver)),
      options_(options),
      rhythm_(step_rhythm(calibration.family, options.rate)),
      signal_(std::move(signal)),
      limiter_(calibration),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

ControlLoop::~ControlLoop() {
  thread_.request_stop();
  const std::scoped_lock lock(mutex_);
  cancel_where_away();
}

/// Under the mutex. Whoever waits for an answer that doesn't come has no time for that now; what a device answers is
/// waited for, or the line would be closed before its servos can be turned off.
void ControlLoop::cancel_where_away() {
  if (status_.state == RobotState::unconfigured || status_.state == RobotState::fault) driver_->cancel();
}

/// Under the mutex. What was ordered before and has not begun is forgotten, but for what takes the torque off.
std::uint64_t ControlLoop::given(Orders orders) {
  orders.number = ++orders_given_;
  orders.stop = orders.stop || orders_.stop;
  orders.deactivate = orders.deactivate || orders_.deactivate;
  orders.halt = orders.halt || orders_.halt;
  orders_ = std::move(orders);
  wake_.notify_all();
  return orders_given_;
}

std::uint64_t ControlLoop::activate(bool confirmed) {
  const std::scoped_lock lock(mutex_);
  wanted_on_ = true;
  needed_until_ = Clock::now() + options_.off_after;
  return given({.activate = confirmed});
}

std::uint64_t ControlLoop::deactivate() {
  const std::scoped_lock lock(mutex_);
  wanted_on_ = false;
  return given({.deactivate = true});
}

std::uint64_t ControlLoop::stop() {
  const std::scoped_lock lock(mutex_);
  wanted_on_ = false;
  cancel_where_away();
  return given({.stop = true});
}

std::uint64_t ControlLoop::place(const Pose& pose) {
  const std::scoped_lock lock(mutex_);
  needed_until_ = Clock::now() + options_.off_after;
  return given({.place = pose});
}

void ControlLoop::halt() {
  const std::scoped_lock lock(mutex_);
  orders_.place.reset();
  orders_.step.reset();
  orders_.halt = true;
  wake_.notify_all();
}

void ControlLoop::order(const StepOrder& step) {
  const std::scoped_lock lock(mutex_);
  orders_.step = step;
  needed_until_ = Clock::now() + options_.off_after;
  wake_.notify_all();
}

bool ControlLoop::place_if_free(const Pose& pose) {
  const std::scoped_lock lock(mutex_);
  const bool taken = status_.state == RobotState::active && wanted_on_ && !orders_.stop && !orders_.deactivate &&
                     !orders_.activate && !orders_.step;
  if (!taken) return false;
  needed_until_ = Clock::now() + options_.off_after;
  given({.place = pose});
  return true;
}

void ControlLoop::keep_on(Clock::time_point now) {
  const std::scoped_lock lock(mutex_);
  needed_until_ = now + options_.off_after;
}

std::vector<StepReport> ControlLoop::take_reports() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(reports_, {});
}

ControlStatus ControlLoop::status() const {
  const std::scoped_lock lock(mutex_);
  return status_;
}

StepTimings ControlLoop::timings() const {
  const std::scoped_lock lock(mutex_);
  return timings_;
}

std::optional<PoseReading> ControlLoop::reading() const {
  const std::scoped_lock lock(mutex_);
  return reading_;
}

void ControlLoop::note(const std::optional<Pose>& position, bool measured) {
  const std::scoped_lock lock(mutex_);
  reading_.reset();
  if (position) reading_ = {.position = *position, .measured = measured, .at = Clock::now(), .number = ++readings_};
}

void ControlLoop::note(const Feedback& feedback) {
  note(feedback.position, feedback.measured);
}

void ControlLoop::enter(RobotState state, const std::string& reason) {
  {
    const std::scoped_lock lock(mutex_);
    status_.servos_off = !may_be_on_ && !release_due_;
    if (status_.state == state && status_.reason == reason) return;
    spdlog::info("{} -> {}{}", to_text(status_.state), to_text(state), reason.empty() ? "" : ": " + reason);
    status_.state = state;
    status_.reason = reason;
  }
  signal_->notify();
}

void ControlLoop::report(StepReport report) {
  {
    const std::scoped_lock lock(mutex_);
    status_.clamped = limiter_.clamped();
    status_.slowed = limiter_.slowed();
    if (report.done) {
      ++status_.steps;
      status_.command_to_line.add(report.command_to_line);
      status_.line_to_state.add(report.line_to_state);
      timings_.add(report.order.time_step, report.command_to_line, report.line_to_state);
    }
    reports_.push_back(std::move(report));
  }
  signal_->notify();
}

void ControlLoop::run(const std::stop_token& stop) {
  {
    std::string granted = make_this_thread_timely();
    const std::scoped_lock lock(mutex_);
    status_.scheduling = std::move(granted);
  }
  while (!stop.stop_requested()) {
    try {
      let_go_where_due();
      driver_->connect();
      serve(stop);
      break;
    } catch (const DriverError& error) {
      fail(error);
    }
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, stop, options_.retry_interval, [this] { return orders_.stop || orders_.deactivate; });
  }
  try {
    if (may_be_on_ || release_due_) driver_->release();
  } catch (const DriverError& error) {
    spdlog::warn("the device has not confirmed at the end that its servos are off: {}{}", error.what(),
                 driver_->let_go() ? "; it has been told once more" : "");
  }
  enter(RobotState::finalized, {});
}

/// Before a device that has failed is connected again. One that gives no answer may still hear, and whoever wants the
/// servos off, or has left them for too long, must not have to wait for it to recover.
void ControlLoop::let_go_where_due() {
  {
    const std::scoped_lock lock(mutex_);
    if (orders_.stop || orders_.deactivate) {
      release_due_ = true;
      release_reason_ = orders_.stop ? "emergency stop" : "";
      taken_ = orders_.number;
      orders_.stop = orders_.deactivate = false;
    } else if (may_be_on_ && !release_due_ && Clock::now() > failed_ + options_.off_after) {
      wanted_on_ = false;
      release_due_ = true;
      release_reason_ = "the device had failed for " + std::to_string(options_.off_after.count()) + " ms";
      spdlog::warn("{}: its servos are to be off", release_reason_);
    }
  }
  if (release_due_ && driver_->let_go()) spdlog::debug("told the device without an answer to let the servos go");
}

/// Until a stop is requested; ends with what the device throws.
void ControlLoop::serve(const std::stop_token& stop) {
  bool on_again = false;
  {
    const std::scoped_lock lock(mutex_);
    status_.device = driver_->description();
    if (Clock::now() > needed_until_) {
      // Whoever wanted them on has been told no, or has gone: a pose that was confirmed then is not one of now.
      wanted_on_ = false;
      orders_.activate.reset();
    }
    on_again = wanted_on_;
  }
  const bool released = release_due_;
  if (release_due_) turn_off(release_reason_);
  const auto present = driver_->present_position();
  note(present, false);
  if (present) limiter_.start_at(*present);
  enter(RobotState::inactive, on_again && !present ? "the device has lost where its servos are; activate it"
                              : released           ? release_reason_
                                                   : "");
  if (on_again && present) turn_on(false);
  while (!stop.stop_requested()) {
    const Orders orders = wait_for_orders(stop, next_wake());
    if (stop.stop_requested()) return;
    obey(orders);
    if (!placing_) settle();
  }
}

Clock::time_point ControlLoop::next_wake() const {
  return placing_ ? next_step_ : last_contact_ + look_interval;
}

ControlLoop::Orders ControlLoop::wait_for_orders(const std::stop_token& stop, Clock::time_point until) {
  std::unique_lock lock(mutex_);
  wake_.wait_until(lock, stop, until, [&] {
    return orders_.stop || orders_.deactivate || orders_.halt || orders_.activate || orders_.place || orders_.step;
  });
  Orders taken = std::exchange(orders_, {.number = orders_given_});
  taken_ = taken.number;
  return taken;
}

/// The orders taken last have come to their end.
void ControlLoop::settle() {
  {
    const std::scoped_lock lock(mutex_);
    if (status_.orders_done == taken_) return;
    status_.orders_done = taken_;
  }
  signal_->notify();
}

void ControlLoop::obey(const Orders& orders) {
  if (orders.halt) placing_.reset();
  if (orders.stop || orders.deactivate) {
    turn_off(orders.stop ? "emergency stop" : "");
    // It came after the other, or would have been forgotten with what was ordered before.
    if (orders.activate) turn_on(*orders.activate);
  } else if (orders.activate) {
    turn_on(*orders.activate);
  } else if (orders.place && on_) {
    placing_ = limiter_.within_range(*orders.place);
    next_step_ = std::max(next_step_, Clock::now());
  } else if (orders.step) {
    make_step(*orders.step);
  } else if (placing_) {
    place_step();
  } else {
    idle();
  }
}

void ControlLoop::turn_on(bool confirmed) {
  if (on_) return;
  {
    // Somebody may have thought better of it meanwhile.
    const std::scoped_lock lock(mutex_);
    if (!wanted_on_ || orders_.stop || orders_.deactivate) return;
  }
  auto start = driver_->present_position();
  if (!start && !confirmed) {
    enter(RobotState::inactive,
          "the device can't tell where its servos are: put the robot into its standing pose and "
          "activate it with --confirm-pose");
    return;
  }
  if (!start) start = limiter_.within_range(standing_pose());
  if (!limiter_.can_start_at(*start, seconds(rhythm_.period))) {
    const std::string why = "a servo stands outside its calibrated range: move it there by hand";
    return may_be_on_ ? turn_off(why) : enter(RobotState::inactive, why);
  }
  // A device that fails while it is turned on may have turned some of them on.
  if (!std::exchange(may_be_on_, true)) failed_ = Clock::now();
  driver_->enable(*start);
  limiter_.start_at(*start);
  on_ = true;
  placing_.reset();
  last_contact_ = next_step_ = Clock::now();
  enter(RobotState::active, {});
}

void ControlLoop::turn_off(const std::string& reason) {
  placing_.reset();
  release_due_ = true;
  release_reason_ = reason;
  driver_->release();
  on_ = may_be_on_ = release_due_ = false;
  enter(RobotState::inactive, reason);
}

/// Waits; whether nobody has wanted the servos off meanwhile, who would not have to wait for the end of a step.
bool ControlLoop::undisturbed_until(Clock::time_point time) {
  std::unique_lock lock(mutex_);
  return !wake_.wait_until(lock, time, [this] { return orders_.stop || orders_.deactivate; });
}

void ControlLoop::give_up(StepReport result) {
  result.reason = "the servos are turned off";
  report(std::move(result));
}

void ControlLoop::make_step(const StepOrder& order) {
  StepReport result{.order = order, .reason = {}};
  if (!on_) return give_up(std::move(result));
  placing_.reset();
  // A step begins a period after the one before, or when its command has come.
  const auto due = next_step_;
  if (!undisturbed_until(due)) return give_up(std::move(result));
  const auto begin = Clock::now();
  const bool in_sequence = order.time_step > 0;
  // Never sooner than a period later: a step that catches up would be faster than the slew rate.
  next_step_ = begin + rhythm_.period;
  try {
    result.commanded = limiter_.limit(order.target, seconds(rhythm_.period));
    driver_->move(result.commanded, std::chrono::duration_cast<std::chrono::microseconds>(rhythm_.move));
    const auto sent = Clock::now();
    result.command_to_line = sent - std::max(order.arrived, due);
    // From when they were told: a program that was held up in between must not take the servos' time.
    if (!undisturbed_until(sent + rhythm_.read)) return give_up(std::move(result));
    const auto feedback = feedback_when_arrived();
    if (!feedback) return give_up(std::move(result));
    result.feedback = *feedback;
    last_contact_ = Clock::now();
    note(result.feedback);
    result.line_to_state = last_contact_ - sent;
    result.done = true;
  } catch (const DriverError& error) {
    result.reason = error.what();
    report(std::move(result));
    throw;
  }
  if (in_sequence) {
    const std::scoped_lock lock(mutex_);
    const bool late = begin > due + rhythm_.period / 4;
    status_.jitter.add(begin - due);
    status_.late_steps += std::uint64_t{late};
    timings_.add_jitter(order.time_step, begin - due, late);
  }
  report(std::move(result));
}

void ControlLoop::count_late_move() {
  const std::scoped_lock lock(mutex_);
  ++status_.late_moves;
}

/// What holds octets back on their way to the device delays a move, and what is read in mid-move is nobody's step. A
/// move that goes on is waited for, then once more as long as after a move in time, for contacts that tell late.
/// Nothing where somebody wants the servos off.
std::optional<Feedback> ControlLoop::feedback_when_arrived() {
  const Feedback feedback = driver_->read();
  if (feedback.arrived || !rhythm_.asks_whether_moving) return feedback;
  if (!driver_->moving()) {
    // It may have ended between the two questions.
    const Feedback later = driver_->read();
    if (later != feedback) count_late_move();
    return later;
  }
  count_late_move();
  const auto until = Clock::now() + longest_arrival;
  do {
    if (Clock::now() > until) {
      throw DriverError(DriverError::Kind::refused, "the servos were still moving " +
                                                        std::to_string(longest_arrival.count()) +
                                                        " ms after the end of their move");
    }
    if (!undisturbed_until(Clock::now() + arrival_interval)) return std::nullopt;
  } while (driver_->moving());
  if (!undisturbed_until(Clock::now() + std::max(rhythm_.read - rhythm_.move, nanoseconds(0)))) return std::nullopt;
  return driver_->read();
}

void ControlLoop::place_step() {
  const auto begin = Clock::now();
  next_step_ = begin + rhythm_.period;
  // Whoever looks on sees the robot move, too.
  note(driver_->read());
  const Pose setpoint = limiter_.limit(*placing_, seconds(rhythm_.period));
  driver_->move(setpoint, std::chrono::duration_cast<std::chrono::microseconds>(rhythm_.period));
  if (!same(setpoint, *placing_)) return;
  if (!undisturbed_until(next_step_)) return;
  note(driver_->read());
  last_contact_ = Clock::now();
  placing_.reset();
}

void ControlLoop::idle() {
  last_contact_ = Clock::now();
  bool off = false;
  {
    const std::scoped_lock lock(mutex_);
    off = on_ && Clock::now() > needed_until_;
    if (off) wanted_on_ = false;
  }
  if (off) {
    turn_off("nobody needed the servos for " + std::to_string(options_.off_after.count()) + " ms");
  } else if (on_) {
    note(driver_->read());
  } else {
    note(driver_->present_position(), false);
  }
}

void ControlLoop::fail(const DriverError& error) {
  const bool was_on = std::exchange(on_, false);
  if (was_on) failed_ = Clock::now();
  placing_.reset();
  note({}, false);
  std::optional<StepOrder> lost;
  RobotState state = RobotState::unconfigured;
  std::string reason = error.what();
  {
    const std::scoped_lock lock(mutex_);
    const bool cancelled = error.kind() == DriverError::Kind::cancelled;
    if (cancelled) reason = status_.reason;
    status_.device_errors += std::uint64_t{!cancelled};
    // What was ordered for a robot that stood there must not move one that has been found again.
    lost = std::exchange(orders_.step, {});
    orders_.place.reset();
    if (was_on || status_.state == RobotState::fault) state = RobotState::fault;
  }
  if (lost) report({.order = *lost, .reason = reason});
  enter(state, reason);
  settle();
}

}  // namespace lamprey::robot_bridge
