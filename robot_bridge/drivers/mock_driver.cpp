#include "robot_bridge/drivers/mock_driver.hpp"

#include "robot_bridge/drivers/feet.hpp"

#include <utility>

namespace lamprey::robot_bridge::drivers {

namespace {

using Kind = DriverError::Kind;

constexpr std::chrono::milliseconds silence{250};

const char* text_of(Kind kind) {
  switch (kind) {
    case Kind::silent:
      return "no answer of the mock";
    case Kind::garbled:
      return "noise instead of an answer of the mock";
    case Kind::refused:
      return "the mock refuses";
    case Kind::disconnected:
      return "the mock is gone";
    case Kind::cancelled:
      return "cancelled";
  }
  return "";
}

}  // namespace

MockDriver::MockDriver(const Calibration& calibration) : calibration_(calibration) {}

template <typename Body>
auto MockDriver::call(Needs needs, const Body& body) {
  std::unique_lock lock(mutex_);
  cancelled_ = false;
  try {
    if (needs == Needs::connection && !connected_) throw DriverError(Kind::disconnected, "the mock is not connected");
    meet_fault(lock);
    return body();
  } catch (...) {
    connected_ = false;
    throw;
  }
}

void MockDriver::meet_fault(std::unique_lock<std::mutex>& lock) {
  if (!fault_) return;
  const MockFault fault = *fault_;
  if (fault.calls > 0 && --fault_->calls == 0) fault_.reset();
  wait(lock, fault.delay);
  if (!fault.error) return;
  if (fault.error == Kind::silent) wait(lock, silence);
  throw DriverError(*fault.error, text_of(*fault.error));
}

void MockDriver::wait(std::unique_lock<std::mutex>& lock, std::chrono::milliseconds duration) {
  if (cancelled_changed_.wait_for(lock, duration, [&] { return cancelled_; })) {
    throw DriverError(Kind::cancelled, text_of(Kind::cancelled));
  }
}

Pose MockDriver::reached(const Pose& target) const {
  Pose pose{};
  for (std::size_t servo = 0; servo < servos; ++servo) {
    pose[servo] = sent_position(calibration_.joints[servo], servo, target[servo]).units;
  }
  return pose;
}

void MockDriver::connect() {
  call(Needs::nothing, [&] {
    connected_ = true;
    enabled_ = false;
  });
}

std::optional<Pose> MockDriver::present_position() {
  return call(Needs::connection, [&] { return std::optional(position_); });
}

void MockDriver::enable(const Pose& /*start*/) {
  call(Needs::connection, [&] { enabled_ = true; });
}

void MockDriver::move(const Pose& target, std::chrono::microseconds /*duration*/) {
  call(Needs::connection, [&] {
    if (!enabled_) throw DriverError(Kind::refused, "the servos were not enabled; a move could make them jump");
    goal_ = reached(target);
    if (delay_ == 0) position_ = goal_;
    ++moves_;
  });
}

Feedback MockDriver::read() {
  return call(Needs::connection, [&] {
    const auto no_inputs = [](std::int32_t) { return false; };
    return Feedback{.position = position_,
                    .measured = true,
                    .feet_down = feet_down(calibration_, position_, no_inputs),
                    .arrived = delay_ == 0};
  });
}

bool MockDriver::moving() {
  return call(Needs::connection, [&] {
    if (delay_ > 0 && --delay_ == 0) position_ = goal_;
    return delay_ > 0;
  });
}

void MockDriver::hold() {
  call(Needs::connection, [] {});
}

void MockDriver::release() {
  call(Needs::connection, [&] { enabled_ = false; });
}

bool MockDriver::let_go() noexcept {
  const std::lock_guard lock(mutex_);
  connected_ = false;
  enabled_ = false;
  return true;
}

void MockDriver::cancel() noexcept {
  const std::lock_guard lock(mutex_);
  cancelled_ = true;
  cancelled_changed_.notify_all();
}

std::string MockDriver::description() const {
  return "the simulator's quadruped";
}

double MockDriver::highest_rate() const {
  return 1000;
}

void MockDriver::inject(MockFault fault) {
  const std::lock_guard lock(mutex_);
  fault_ = fault.calls == 0 ? std::nullopt : std::optional(fault);
}

void MockDriver::delay_next_move(int questions) {
  const std::lock_guard lock(mutex_);
  delay_ = questions;
}

void MockDriver::put(const Pose& position) {
  const std::lock_guard lock(mutex_);
  position_ = reached(position);
}

Pose MockDriver::position() const {
  const std::lock_guard lock(mutex_);
  return position_;
}

bool MockDriver::is_connected() const {
  const std::lock_guard lock(mutex_);
  return connected_;
}

bool MockDriver::is_enabled() const {
  const std::lock_guard lock(mutex_);
  return enabled_;
}

std::uint64_t MockDriver::moves() const {
  const std::lock_guard lock(mutex_);
  return moves_;
}

}  // namespace lamprey::robot_bridge::drivers
