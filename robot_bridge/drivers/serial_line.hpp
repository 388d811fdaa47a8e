#pragma once

#include "robot_bridge/driver.hpp"

#include <asio/error_code.hpp>
#include <asio/io_context.hpp>
#include <asio/serial_port.hpp>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lamprey::robot_bridge::drivers {

/// A serial line (or a pseudo-terminal): 8 data bits, no parity, 1 stop bit, raw, no flow control, and nobody else's
/// while it is open. Every wait has a deadline. One thread uses it; only `cancel` may be called from others.
class SerialLine {
 public:
  using Clock = std::chrono::steady_clock;
  using Deadline = Clock::time_point;

  SerialLine(std::string port, std::int32_t baud) : port_(std::move(port)), baud_(baud), serial_(io_) {}
  ~SerialLine();
  SerialLine(const SerialLine&) = delete;
  SerialLine& operator=(const SerialLine&) = delete;

  const std::string& port() const { return port_; }
  std::int32_t baud() const { return baud_; }
  bool is_open() const { return serial_.is_open(); }

  /// Closes it first where it is open. Throws DriverError::Kind::disconnected.
  void open();
  void close() noexcept;

  /// A cancel before this is forgotten.
  void begin_call() noexcept { cancelled_ = false; }

  // The following throw DriverError: disconnected where the line is gone or not open, cancelled.

  /// Throws DriverError::Kind::silent where the line does not take all octets by the deadline.
  void write(std::span<const std::uint8_t> octets, Deadline deadline);

  /// What there is, at least an octet; none at the deadline.
  std::vector<std::uint8_t> read_some(Deadline deadline);

  /// Throws DriverError: silent where nothing has come by the deadline, garbled where less than `count`.
  std::vector<std::uint8_t> read_exactly(std::size_t count, Deadline deadline);

  /// Up to `last`, which is taken away. As read_exactly; garbled also where `last` isn't among the first `at_most`.
  std::vector<std::uint8_t> read_until(std::uint8_t last, std::size_t at_most, Deadline deadline);

  /// How many octets have come that nobody has read, as far as they are known without waiting.
  std::size_t waiting();

  /// Forgets what has come and was not read.
  void drain_input();

  /// Ends what is going on, until begin_call. From any thread.
  void cancel() noexcept;

  /// How long so many octets are on the wire.
  std::chrono::microseconds wire_time(std::size_t octets) const;

 private:
  using Done = std::function<void(const asio::error_code&, std::size_t)>;

  /// Starts an operation of Asio's, and waits: how many octets it has moved, or none at the deadline.
  std::optional<std::size_t> run(const std::function<void(Done)>& start, Deadline deadline);
  void take_what_is_there();
  void throw_if_unusable() const;
  [[noreturn]] void fail(const std::string& what, const asio::error_code& error) const;

  const std::string port_;
  const std::int32_t baud_;
  asio::io_context io_;
  asio::serial_port serial_;
  std::vector<std::uint8_t> input_;  ///< has come, was not read
  std::atomic<bool> cancelled_ = false;
};

}  // namespace lamprey::robot_bridge::drivers
