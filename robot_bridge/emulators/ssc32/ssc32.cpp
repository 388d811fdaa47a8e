#include "robot_bridge/emulators/ssc32/ssc32.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace lamprey::robot_bridge::emulators::ssc32 {
namespace {

constexpr std::uint8_t carriage_return = 13;
constexpr std::uint8_t escape = 27;
constexpr std::size_t longest_line = 1024;
constexpr double query_unit = 10;  // µs
/// The first reading of a pin that was digital before is worth nothing.
constexpr std::uint8_t invalid_reading = 0x7F;
constexpr std::uint8_t five_volts = 255;

/// "All channels start and end the move simultaneously", no servo is faster than its speed says, and the move takes no
/// less than its time (SSC-32U user guide, "Command group").
Time duration(const Move& move, const std::vector<Channel>& channels, Time now) {
  double seconds = move.milliseconds.value_or(0) / 1000.0;
  for (const auto& [channel, pulse, speed] : move.targets) {
    const Channel& servo = channels[channel];
    if (speed.value_or(0) == 0 || pulse == 0 || !servo.on()) continue;
    seconds = std::max(seconds, std::abs(pulse - servo.pulse(now)) / *speed);
  }
  return std::chrono::duration_cast<Time>(std::chrono::duration<double>(seconds));
}

}  // namespace

Ssc32::Ssc32(Settings settings, Recorder& recorder, Time now)
    : settings_(std::move(settings)),
      recorder_(&recorder),
      channels_(channels, Channel(settings_.position, settings_.speed)),
      advanced_(now) {
  power_up();
}

void Ssc32::power_up() {
  for (unsigned input = 0; input < digital_inputs; ++input) inputs_[input] = DebouncedInput(!contact(input));
  analog_.fill(false);
  line_.clear();
  line_too_long_ = false;
  moving_until_ = Time{};
}

void Ssc32::receive(std::uint8_t octet, Time time) {
  if (octet == escape) {
    line_.clear();
    line_too_long_ = false;
  } else if (octet != carriage_return) {
    line_too_long_ = line_too_long_ || line_.size() == longest_line;
    if (!line_too_long_) line_ += static_cast<char>(octet);
  } else {
    const std::string line = std::exchange(line_, {});
    const Command command = std::exchange(line_too_long_, false) ? Bad{"length"} : parse(line);
    advance(time);
    std::visit([this, time](const auto& what) { act(what, time); }, command);
  }
}

std::vector<Answer> Ssc32::take_answers() {
  return std::exchange(answers_, {});
}

void Ssc32::act(const Bad& bad, Time) {
  recorder_->refused(bad.reason);
}

void Ssc32::act(const Move& move, Time time) {
  const Time whole = duration(move, channels_, time);
  for (const auto& [number, pulse, speed] : move.targets) {
    Channel& channel = channels_[number];
    settings_.servos.insert(number);
    if (pulse == 0) {
      if (channel.on()) recorder_->turned_off(number, time);
      channel.turn_off();
      continue;
    }
    if (!channel.on()) recorder_->turned_on(number, channel.position(), pulse, time);
    recorder_->target(number, pulse, whole, time);
    channel.move(pulse, time, whole);
  }
  moving_until_ = std::max(moving_until_, time + whole);
}

void Ssc32::act(const Stop& stop, Time time) {
  // A timed move of which it was a part goes on, as far as Q is concerned.
  channels_[stop.channel].stop(time);
}

void Ssc32::act(const QueryMovement&, Time time) {
  answer({static_cast<std::uint8_t>(time < moving_until_ ? '+' : '.')}, time);
}

void Ssc32::act(const QueryPulses& query, Time time) {
  std::vector<std::uint8_t> octets;
  for (const unsigned number : query.channels) {
    const Channel& channel = channels_[number];
    const double pulse = channel.on() ? channel.pulse(time) : 0;
    octets.push_back(static_cast<std::uint8_t>(std::lround(pulse / query_unit)));
  }
  answer(std::move(octets), time);
}

void Ssc32::act(const QueryVersion&, Time time) {
  std::vector<std::uint8_t> octets(settings_.version.begin(), settings_.version.end());
  octets.push_back(carriage_return);
  answer(std::move(octets), time);
}

void Ssc32::act(const ReadDigital& read, Time time) {
  std::vector<std::uint8_t> octets;
  for (const auto& [number, latched] : read.inputs) {
    DebouncedInput& input = inputs_[number];
    octets.push_back(static_cast<std::uint8_t>((latched ? input.high_throughout() : input.high()) ? '1' : '0'));
  }
  answer(std::move(octets), time);
}

void Ssc32::act(const ReadAnalog& read, Time time) {
  std::vector<std::uint8_t> octets;
  for (const unsigned input : read.inputs) {
    const bool valid = std::exchange(analog_[input], true);
    const bool open =
        std::ranges::any_of(settings_.feet, [&](const FootSwitch& foot) { return foot.input == input; }) &&
        !contact(input);
    octets.push_back(!valid ? invalid_reading : open ? five_volts : std::uint8_t{0});
  }
  answer(std::move(octets), time);
}

void Ssc32::answer(std::vector<std::uint8_t> octets, Time time) {
  answers_.push_back({std::move(octets), time, settings_.answer_delay, settings_.answer_gap});
}

bool Ssc32::contact(unsigned input) const {
  return std::ranges::any_of(settings_.feet, [&](const FootSwitch& foot) {
    return foot.input == input && foot.closed_at(channels_[foot.servo].position());
  });
}

bool Ssc32::at_rest() const {
  return std::ranges::all_of(inputs_, &DebouncedInput::settled) &&
         std::ranges::all_of(channels_, [this](const Channel& channel) { return channel.at_rest(advanced_); });
}

void Ssc32::advance(Time time) {
  while (time - advanced_ >= tick) {
    if (at_rest()) {
      advanced_ += (time - advanced_) / tick * tick;
      return;
    }
    advanced_ += tick;
    for (Channel& channel : channels_) channel.follow(advanced_);
    for (unsigned input = 0; input < digital_inputs; ++input) inputs_[input].look(!contact(input));
  }
}

Channel& Ssc32::existing(unsigned servo) {
  if (servo >= channels) throw std::invalid_argument("no servo '" + std::to_string(servo) + "': channels are 0..31");
  return channels_[servo];
}

void Ssc32::overload(unsigned servo, bool on, Time time) {
  Channel& channel = existing(servo);
  advance(time);
  channel.stall(on);
}

void Ssc32::place(unsigned servo, double position, Time time) {
  Channel& channel = existing(servo);
  if (channel.on()) throw std::invalid_argument("servo " + std::to_string(servo) + " is on and holds its position");
  if (!(position >= shortest_pulse && position <= longest_pulse)) {
    throw std::invalid_argument("a servo's position is in 500..2500");
  }
  advance(time);
  channel.place(position);
  // The contact that this opens or closes is seen by the ticks that follow.
  for (unsigned input = 0; input < digital_inputs; ++input) inputs_[input].look(!contact(input));
}

void Ssc32::reset(Time time) {
  advance(time);
  for (unsigned number = 0; number < channels; ++number) {
    if (channels_[number].on()) recorder_->turned_off(number, time);
    channels_[number].turn_off();
    channels_[number].stall(false);
  }
  answers_.clear();
  power_up();
}

nlohmann::json Ssc32::state(Time time) {
  advance(time);
  auto servos = nlohmann::json::object();
  for (const unsigned number : settings_.servos) {
    const Channel& channel = channels_[number];
    auto& servo = servos[std::to_string(number)] = {{"on", channel.on()},
                                                    {"position", channel.position()},
                                                    {"pulse", nullptr},
                                                    {"target", nullptr},
                                                    {"overloaded", channel.stalled()}};
    if (!channel.on()) continue;
    servo["pulse"] = channel.pulse(time);
    servo["target"] = channel.target();
  }
  auto contacts = nlohmann::json::object();
  for (const FootSwitch& foot : settings_.feet) {
    contacts[std::string(1, static_cast<char>('A' + foot.input))] = contact(foot.input);
  }
  return {{"servos", servos}, {"contacts", contacts}, {"moving", time < moving_until_}};
}

}  // namespace lamprey::robot_bridge::emulators::ssc32
