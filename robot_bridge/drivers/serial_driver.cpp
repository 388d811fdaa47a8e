#include "robot_bridge/drivers/serial_driver.hpp"

#include <exception>
#include <utility>

namespace lamprey::robot_bridge::drivers {

namespace {

/// A controller answers within a few milliseconds; a USB adapter and a busy machine need some, too.
constexpr std::chrono::milliseconds answer_time{250};

}  // namespace

SerialDriver::SerialDriver(const Calibration& calibration, std::string port)
    : calibration_(calibration), line_(std::move(port), calibration_.baud) {}

template <typename Body>
auto SerialDriver::call(const Body& body) {
  line_.begin_call();
  try {
    return body();
  } catch (...) {
    line_.close();
    throw;
  }
}

void SerialDriver::connect() {
  call([&] {
    enabled_ = false;
    sent = {};
    line_.open();
    greet();
  });
}

std::optional<Pose> SerialDriver::present_position() {
  return call([&] { return locate(); });
}

void SerialDriver::enable(const Pose& start) {
  call([&] {
    turn_on(start);
    enabled_ = true;
  });
}

void SerialDriver::move(const Pose& target, std::chrono::microseconds duration) {
  call([&] {
    if (!enabled_ && line_.is_open()) {
      throw DriverError(DriverError::Kind::refused, "the servos were not enabled; a move could make them jump");
    }
    // All or none.
    auto next = sent;
    for (std::size_t servo = 0; servo < servos; ++servo) {
      next[servo] = sent_position(joint(servo), servo, target[servo]);
    }
    sent = next;
    begin_move(duration);
  });
}

Feedback SerialDriver::read() {
  return call([&] { return sense(); });
}

bool SerialDriver::moving() {
  return call([&] { return ask_whether_moving(); });
}

void SerialDriver::hold() {
  call([&] {
    sent = {};
    stop();
  });
}

void SerialDriver::release() {
  call([&] {
    sent = {};
    enabled_ = false;
    send_release();
    confirm_release();
  });
}

bool SerialDriver::let_go() noexcept {
  try {
    call([&] {
      enabled_ = false;
      sent = {};
      line_.open();
      send_release();
    });
    line_.close();
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

SerialLine::Deadline SerialDriver::answer_deadline(std::size_t octets) const {
  return SerialLine::Clock::now() + answer_time + line_.wire_time(octets);
}

}  // namespace lamprey::robot_bridge::drivers
