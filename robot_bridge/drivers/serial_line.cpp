#include "robot_bridge/drivers/serial_line.hpp"

#include <algorithm>
#include <array>
#include <asio/buffer.hpp>
#include <asio/post.hpp>
#include <cerrno>
#include <linux/serial.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <system_error>
#include <termios.h>
#include <utility>

namespace lamprey::robot_bridge::drivers {

namespace {

using Kind = DriverError::Kind;

constexpr int bits_per_octet = 10;  // a start bit, 8 of data, a stop bit
constexpr std::size_t most_octets_at_once = 512;

/// USB adapters keep octets back for up to 16 ms, unless asked not to. One that can't be asked is used as it is.
void ask_for_low_latency(int descriptor) {
  serial_struct settings{};
  if (::ioctl(descriptor, TIOCGSERIAL, &settings) != 0) return;
  settings.flags |= static_cast<int>(ASYNC_LOW_LATENCY);
  static_cast<void>(::ioctl(descriptor, TIOCSSERIAL, &settings));
}

}  // namespace

SerialLine::~SerialLine() {
  close();
}

void SerialLine::open() {
  close();
  asio::error_code error;
  static_cast<void>(serial_.open(port_, error));
  if (error) fail("can't be opened", error);
  const int descriptor = serial_.native_handle();
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    const bool taken = errno == EWOULDBLOCK;
    const asio::error_code why(errno, std::system_category());
    close();
    if (taken) throw DriverError(Kind::disconnected, "serial line '" + port_ + "' is in use by another program");
    fail("can't be locked", why);
  }
  const auto set = [&](const auto& option) {
    if (!error) static_cast<void>(serial_.set_option(option, error));
  };
  set(asio::serial_port::baud_rate(static_cast<unsigned>(baud_)));
  set(asio::serial_port::character_size(8));
  set(asio::serial_port::parity(asio::serial_port::parity::none));
  set(asio::serial_port::stop_bits(asio::serial_port::stop_bits::one));
  set(asio::serial_port::flow_control(asio::serial_port::flow_control::none));
  if (error) {
    close();
    fail("can't be set to " + std::to_string(baud_) + " baud, 8N1", error);
  }
  ask_for_low_latency(descriptor);
}

void SerialLine::close() noexcept {
  asio::error_code ignored;
  static_cast<void>(serial_.close(ignored));
  input_.clear();
}

void SerialLine::write(std::span<const std::uint8_t> octets, Deadline deadline) {
  while (!octets.empty()) {
    const auto written =
        run([&](Done done) { serial_.async_write_some(asio::buffer(octets.data(), octets.size()), std::move(done)); },
            deadline);
    if (!written) throw DriverError(Kind::silent, "serial line '" + port_ + "' takes no more octets");
    octets = octets.subspan(*written);
  }
}

std::vector<std::uint8_t> SerialLine::read_some(Deadline deadline) {
  throw_if_unusable();
  if (!input_.empty()) return std::exchange(input_, {});
  std::vector<std::uint8_t> octets(most_octets_at_once);
  const auto read =
      run([&](Done done) { serial_.async_read_some(asio::buffer(octets.data(), octets.size()), std::move(done)); },
          deadline);
  octets.resize(read.value_or(0));
  return octets;
}

std::vector<std::uint8_t> SerialLine::read_exactly(std::size_t count, Deadline deadline) {
  std::vector<std::uint8_t> octets;
  while (octets.size() < count) {
    const auto more = read_some(deadline);
    if (more.empty()) {
      if (octets.empty()) throw DriverError(Kind::silent, "no answer on serial line '" + port_ + "'");
      throw DriverError(Kind::garbled, "an answer of " + std::to_string(octets.size()) + " octets instead of " +
                                           std::to_string(count) + " on serial line '" + port_ + "'");
    }
    octets.insert(octets.end(), more.begin(), more.end());
  }
  const auto end = octets.begin() + static_cast<std::ptrdiff_t>(count);
  input_.assign(end, octets.end());
  octets.erase(end, octets.end());
  return octets;
}

std::vector<std::uint8_t> SerialLine::read_until(std::uint8_t last, std::size_t at_most, Deadline deadline) {
  std::vector<std::uint8_t> octets;
  while (true) {
    const auto end = std::ranges::find(octets, last);
    if (end != octets.end()) {
      input_.assign(end + 1, octets.end());
      octets.erase(end, octets.end());
      return octets;
    }
    const auto more = octets.size() < at_most ? read_some(deadline) : std::vector<std::uint8_t>();
    if (more.empty()) {
      if (octets.empty()) throw DriverError(Kind::silent, "no answer on serial line '" + port_ + "'");
      throw DriverError(Kind::garbled, "an answer without an end on serial line '" + port_ + "'");
    }
    octets.insert(octets.end(), more.begin(), more.end());
  }
}

std::size_t SerialLine::waiting() {
  throw_if_unusable();
  int count = 0;
  static_cast<void>(::ioctl(serial_.native_handle(), FIONREAD, &count));
  return input_.size() + static_cast<std::size_t>(std::max(count, 0));
}

void SerialLine::drain_input() {
  throw_if_unusable();
  input_.clear();
  static_cast<void>(::tcflush(serial_.native_handle(), TCIFLUSH));
}

void SerialLine::cancel() noexcept {
  cancelled_ = true;
  try {
    // Wakes whoever waits.
    asio::post(io_, [] {});
  } catch (const std::exception&) {
    // Without memory the wait ends at its deadline, and then as cancelled.
  }
}

std::chrono::microseconds SerialLine::wire_time(std::size_t octets) const {
  return std::chrono::microseconds(std::int64_t{1'000'000} * bits_per_octet * static_cast<std::int64_t>(octets) /
                                   baud_);
}

std::optional<std::size_t> SerialLine::run(const std::function<void(Done)>& start, Deadline deadline) {
  throw_if_unusable();
  bool is_done = false;
  asio::error_code error;
  std::size_t octets = 0;
  start([&](const asio::error_code& result, std::size_t moved) {
    is_done = true;
    error = result;
    octets = moved;
  });
  io_.restart();
  while (!is_done && !cancelled_) {
    if (io_.run_one_until(deadline) != 0 || Clock::now() < deadline) continue;
    // What came in time counts, also where this thread was kept from looking.
    io_.poll();
    break;
  }
  const bool in_time = is_done;
  if (!in_time) {
    asio::error_code ignored;
    static_cast<void>(serial_.cancel(ignored));
    // Asio refers to this function's variables until it has called back.
    while (!is_done) io_.run_one();
  }
  throw_if_unusable();
  if (!error) return octets;
  if (!in_time && error == asio::error::operation_aborted) return std::nullopt;
  fail("is gone", error);
}

void SerialLine::throw_if_unusable() const {
  if (cancelled_) throw DriverError(Kind::cancelled, "cancelled");
  if (!serial_.is_open()) throw DriverError(Kind::disconnected, "serial line '" + port_ + "' is not connected");
}

void SerialLine::fail(const std::string& what, const asio::error_code& error) const {
  throw DriverError(Kind::disconnected, "serial line '" + port_ + "' " + what + ": " + error.message());
}

}  // namespace lamprey::robot_bridge::drivers
