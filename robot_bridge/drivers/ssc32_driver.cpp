#include "robot_bridge/drivers/ssc32_driver.hpp"

#include "robot_bridge/drivers/feet.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace lamprey::robot_bridge::drivers {

namespace {

using Kind = DriverError::Kind;

constexpr double pulses_per_second = 50;  // of any servo's PWM signal: more moves than that are never seen
constexpr double answer_delay = 0.005;    // seconds: the longest before an answer, by the user guide
constexpr int version_attempts = 3;       // the line may be noisy where it has just been plugged in
constexpr std::size_t longest_version = 64;

std::vector<std::int32_t> channels_of(const Calibration& calibration) {
  std::vector<std::int32_t> channels;
  for (const auto& joint : calibration.joints) channels.push_back(joint.channel);
  return channels;
}

std::span<const std::uint8_t> octets_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

Ssc32Driver::Ssc32Driver(const Calibration& calibration, std::string port)
    : SerialDriver(calibration, std::move(port)),
      channels_(channels_of(calibration)),
      inputs_(contact_channels(calibration)) {}

std::string Ssc32Driver::description() const {
  std::array<char, 32> rate{};
  std::snprintf(rate.data(), rate.size(), "%.4g", std::floor(highest_rate() * 10) / 10);
  std::string text = "SSC-32 at " + line().port() + ", " + std::to_string(line().baud()) + " baud, version " +
                     (version_.empty() ? "unknown" : version_) + ", at most " + rate.data() + " steps per second";
  if (highest_rate() < pulses_per_second) text += " (50 take 115200 baud)";
  return text;
}

double Ssc32Driver::highest_rate() const {
  std::vector<ssc32::ServoPulse> widest;
  for (const auto channel : channels_) widest.push_back({.channel = channel, .pulse = ssc32::highest_pulse});
  const std::size_t octets = ssc32::move_command(widest, std::chrono::milliseconds(999)).size() +
                             ssc32::pulse_query(channels_).size() + channels_.size() +
                             ssc32::input_query(inputs_).size() + inputs_.size();
  const double seconds = std::chrono::duration<double>(line().wire_time(octets)).count() + answer_delay;
  return std::min(pulses_per_second, 1 / seconds);
}

void Ssc32Driver::greet() {
  version_.clear();
  reach_ = {};
  const std::string query = ssc32::version_query();
  for (int attempt = 1; version_.empty(); ++attempt) {
    try {
      line().drain_input();
      write(query);
      const auto answer =
          line().read_until(ssc32::line_end, longest_version, answer_deadline(query.size() + longest_version));
      if (const auto version = ssc32::version_of(answer)) {
        version_ = *version;
      } else if (attempt == version_attempts) {
        throw DriverError(Kind::garbled, "what answers on serial line '" + line().port() + "' is no SSC-32");
      }
    } catch (const DriverError& error) {
      const bool passing = error.kind() == Kind::silent || error.kind() == Kind::garbled;
      if (!passing || attempt == version_attempts) throw;
    }
  }
}

std::optional<Pose> Ssc32Driver::locate() {
  const Answer answer = ask_twice();
  Pose pose{};
  for (std::size_t servo = 0; servo < servos; ++servo) {
    if (answer.tens[servo] == 0) return std::nullopt;
    pose[servo] = units_of(servo, answer.tens[servo]);
  }
  return pose;
}

void Ssc32Driver::turn_on(const Pose& start) {
  const Answer answer = ask_twice();
  std::vector<ssc32::ServoPulse> off;
  for (std::size_t servo = 0; servo < servos; ++servo) {
    const auto position = sent_position(joint(servo), servo, start[servo]);
    if (answer.tens[servo] == 0) {
      off.push_back({.channel = joint(servo).channel, .pulse = position.device});
      sent[servo] = position;
      reach_[servo] = Reach{position.device, position.device};
    } else {
      if (ssc32::tells_pulse(answer.tens[servo], position.device)) sent[servo] = position;
      reach_[servo] = Reach{10 * answer.tens[servo], 10 * answer.tens[servo]};
    }
  }
  if (!off.empty()) write(ssc32::start_command(off));
}

void Ssc32Driver::begin_move(std::chrono::microseconds duration) {
  for (std::size_t servo = 0; servo < servos; ++servo) {
    auto& reach = reach_[servo];
    if (!reach) continue;
    reach->lowest = std::min(reach->lowest, sent[servo]->device);
    reach->highest = std::max(reach->highest, sent[servo]->device);
  }
  write(ssc32::move_command(sent_pulses(), duration));
}

Feedback Ssc32Driver::sense() {
  const Answer answer = ask(true);
  if (is_enabled()) check(answer.tens);
  Feedback feedback;
  for (std::size_t servo = 0; servo < servos; ++servo) {
    if (answer.tens[servo] != 0) feedback.position[servo] = units_of(servo, answer.tens[servo]);
    if (sent[servo] && !ssc32::tells_pulse(answer.tens[servo], sent[servo]->device)) feedback.arrived = false;
  }
  feedback.feet_down = feet_down(calibration(), feedback.position, [&](std::int32_t input) {
    return answer.inputs[static_cast<std::size_t>(std::ranges::find(inputs_, input) - inputs_.begin())];
  });
  return feedback;
}

bool Ssc32Driver::ask_whether_moving() {
  const std::string query = ssc32::movement_query();
  line().drain_input();
  write(query);
  const auto octets = line().read_exactly(1, answer_deadline(query.size() + 1));
  const auto moving = ssc32::is_moving(octets);
  if (!moving || line().waiting() > 0) {
    throw DriverError(Kind::garbled, "noise instead of an answer on serial line '" + line().port() + "'");
  }
  return *moving;
}

void Ssc32Driver::stop() {
  write(ssc32::stop_commands(channels_));
}

void Ssc32Driver::send_release() {
  reach_ = {};
  write(ssc32::release_command(channels_));
}

void Ssc32Driver::confirm_release() {
  const Answer answer = ask(false);
  for (std::size_t servo = 0; servo < servos; ++servo) {
    if (answer.tens[servo] != 0)
      throw DriverError(Kind::refused, servo_text(calibration(), servo) + " keeps its pulses");
  }
}

/// Answers have no checksum, and most octets of noise look like a pulse. A servo that is taken to be where it isn't
/// jumps with the next move.
Ssc32Driver::Answer Ssc32Driver::ask_twice() {
  const Answer first = ask(false);
  const Answer second = ask(false);
  if (first.tens != second.tens) {
    throw DriverError(Kind::garbled,
                      "two answers that differ on serial line '" + line().port() + "': noise, or the servos move");
  }
  return second;
}

/// A servo that is on is between where it was and where it was sent, or the answer is noise.
void Ssc32Driver::check(const std::vector<std::int32_t>& tens) {
  constexpr std::int32_t unit = 10;
  for (std::size_t servo = 0; servo < servos; ++servo) {
    if (tens[servo] == 0) {
      throw DriverError(Kind::refused, servo_text(calibration(), servo) +
                                           " has no pulses any more: the controller was reset, or its power failed");
    }
    auto& reach = reach_[servo];
    if (!reach) continue;
    const std::int32_t pulse = unit * tens[servo];
    if (pulse < reach->lowest - unit || pulse > reach->highest + unit) {
      throw DriverError(Kind::garbled, servo_text(calibration(), servo) + " can't be at " + std::to_string(pulse) +
                                           " µs, between " + std::to_string(reach->lowest) + " and " +
                                           std::to_string(reach->highest) + " µs as it is: noise on serial line '" +
                                           line().port() + "'");
    }
    const std::int32_t goal = sent[servo] ? sent[servo]->device : pulse;
    reach = Reach{std::min(pulse, goal), std::max(pulse, goal)};
  }
}

/// One line for the servos and one for the inputs, sent together: with a USB adapter, waiting for two answers would
/// cost more than the octets.
Ssc32Driver::Answer Ssc32Driver::ask(bool with_inputs) {
  const std::string query = ssc32::pulse_query(channels_) + (with_inputs ? ssc32::input_query(inputs_) : "");
  const std::size_t expected = channels_.size() + (with_inputs ? inputs_.size() : 0);
  line().drain_input();
  write(query);
  const auto octets = line().read_exactly(expected, answer_deadline(query.size() + expected));
  const std::span answer(octets);
  const auto tens = ssc32::tens_of_microseconds(answer.first(channels_.size()));
  const auto inputs = ssc32::input_levels(answer.subspan(channels_.size()));
  if (!tens || !inputs || line().waiting() > 0) {
    throw DriverError(Kind::garbled, "noise instead of an answer on serial line '" + line().port() + "'");
  }
  return {.tens = *tens, .inputs = *inputs};
}

/// Exactly what was asked for, where that is what the device tells.
double Ssc32Driver::units_of(std::size_t servo, std::int32_t tens) const {
  if (sent[servo] && ssc32::tells_pulse(tens, sent[servo]->device)) return sent[servo]->units;
  return joint(servo).to_units(10.0 * tens);
}

void Ssc32Driver::write(const std::string& text) {
  line().write(octets_of(text), answer_deadline(text.size()));
}

std::vector<ssc32::ServoPulse> Ssc32Driver::sent_pulses() const {
  std::vector<ssc32::ServoPulse> pulses;
  for (std::size_t servo = 0; servo < servos; ++servo) {
    if (sent[servo]) pulses.push_back({.channel = joint(servo).channel, .pulse = sent[servo]->device});
  }
  return pulses;
}

}  // namespace lamprey::robot_bridge::drivers
