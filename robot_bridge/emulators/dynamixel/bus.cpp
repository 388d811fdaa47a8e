#include "robot_bridge/emulators/dynamixel/bus.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>

namespace lamprey::robot_bridge::emulators::dynamixel {
namespace {

std::uint16_t number(std::span<const std::uint8_t> octets, std::size_t at) {
  return static_cast<std::uint16_t>(octets[at] | octets[at + 1] << 8);
}

const char* name(Error error) {
  switch (error) {
    case Error::result_fail:
      return "result fail";
    case Error::instruction:
      return "instruction error";
    case Error::crc:
      return "CRC error";
    case Error::data_range:
      return "data range error";
    case Error::data_length:
      return "data length error";
    case Error::data_limit:
      return "data limit error";
    case Error::access:
      return "access error";
    case Error::none:
      break;
  }
  return "none";
}

constexpr std::size_t address_octets = 2;
constexpr std::size_t range_octets = 4;  ///< an address and a length

}  // namespace

std::optional<std::uint8_t> baud_register(unsigned baud) {
  constexpr std::array speeds{9600U, 57600U, 115200U, 1000000U, 2000000U, 3000000U, 4000000U, 4500000U};
  const auto* const found = std::ranges::find(speeds, baud);
  if (found == speeds.end()) return std::nullopt;
  return static_cast<std::uint8_t>(found - speeds.begin());
}

Bus::Bus(const Settings& settings, Recorder& recorder, Time now)
    : settings_(settings), recorder_(&recorder), advanced_(now) {
  for (const std::uint8_t id : settings_.servos) {
    ServoSettings servo = settings_.servo;
    servo.id = id;
    servos_.try_emplace(id, servo, recorder);
  }
  if (!settings_.board) return;
  board_ = std::make_unique<ContactBoard>(settings_.board->id, settings_.servo.baud_register, settings_.board->address,
                                          [this] { return contacts(); });
}

void Bus::receive(std::uint8_t octet, Time time) {
  const auto skipped = decoder_.skipped();
  const auto packet = decoder_.take(octet);
  if (decoder_.skipped() != skipped) recorder_->refused("octets outside of packets");
  if (!packet) return;
  advance(time);
  for (auto& [id, servo] : servos_) servo.heard(time);
  handle(*packet, time);
}

std::vector<Answer> Bus::take_answers() {
  return std::exchange(answers_, {});
}

void Bus::handle(const Packet& packet, Time time) {
  if (packet.instruction == static_cast<std::uint8_t>(Instruction::status)) return;
  if (packet.id == broadcast) {
    if (packet.intact) return handle_for_all(packet, time);
    recorder_->refused(name(Error::crc));
    return;
  }
  Device* const device = find(packet.id);
  if (device == nullptr) {
    recorder_->refused("for an id that is not there");
  } else if (!packet.intact) {
    answer(packet.id, *device, counted(Error::crc), {}, time);
  } else {
    handle_for_one(packet.id, *device, packet, true, time);
  }
}

/// Each device does it, and none but those that are to be read answers.
void Bus::handle_for_all(const Packet& packet, Time time) {
  switch (static_cast<Instruction>(packet.instruction)) {
    case Instruction::ping:
      for (auto& [id, servo] : servos_) ping(static_cast<std::uint8_t>(id), servo, time);
      if (board_) ping(settings_.board->id, *board_, time);
      return;
    case Instruction::sync_read:
      return sync_read(packet.parameters, time);
    case Instruction::sync_write:
      return sync_write(packet.parameters, time);
    case Instruction::bulk_read:
      return bulk_read(packet.parameters, time);
    case Instruction::bulk_write:
      return bulk_write(packet.parameters, time);
    default:
      for (auto& [id, servo] : servos_) {
        handle_for_one(static_cast<std::uint8_t>(id), servo, packet, false, time);
      }
  }
}

void Bus::handle_for_one(std::uint8_t id, Device& device, const Packet& packet, bool answers, Time time) {
  const Octets parameters = packet.parameters;
  const auto write = [&](auto&& how) {
    return parameters.size() <= address_octets ? Error::data_length
                                               : how(number(parameters, 0), parameters.subspan(address_octets));
  };
  Error error = Error::instruction;
  switch (static_cast<Instruction>(packet.instruction)) {
    case Instruction::ping:
      return ping(id, device, time);
    case Instruction::read:
      if (answers) read(id, device, parameters, time);
      return;
    case Instruction::write:
      error = write([&](std::uint16_t address, Octets octets) { return device.write(address, octets, time); });
      break;
    case Instruction::reg_write:
      error = write([&](std::uint16_t address, Octets octets) { return device.reg_write(address, octets); });
      break;
    case Instruction::action:
      error = device.action(time);
      break;
    case Instruction::reboot:
      device.reboot(time);
      error = Error::none;
      break;
    default:
      break;
  }
  counted(error);
  if (answers && device.status_return_level() == 2) answer(id, device, error, {}, time);
}

void Bus::ping(std::uint8_t id, const Device& device, Time time) {
  const std::array<std::uint8_t, 3> who{static_cast<std::uint8_t>(device.model()),
                                        static_cast<std::uint8_t>(device.model() >> 8U), device.firmware()};
  answer(id, device, Error::none, who, time);
}

void Bus::read(std::uint8_t id, Device& device, Octets parameters, Time time) {
  std::vector<std::uint8_t> values;
  const Error error = parameters.size() != range_octets
                          ? Error::data_length
                          : device.read(number(parameters, 0), number(parameters, 2), values);
  counted(error);
  if (device.status_return_level() > 0) answer(id, device, error, values, time);
}

void Bus::sync_read(Octets parameters, Time time) {
  if (parameters.size() <= range_octets) return void(counted(Error::data_length));
  for (const std::uint8_t id : parameters.subspan(range_octets)) {
    if (Device* const device = find(id)) read(id, *device, parameters.first(range_octets), time);
  }
}

void Bus::sync_write(Octets parameters, Time time) {
  const std::size_t length = parameters.size() < range_octets ? 0 : number(parameters, 2);
  const Octets rest = parameters.subspan(std::min(range_octets, parameters.size()));
  if (length == 0 || rest.empty() || rest.size() % (length + 1) != 0) return void(counted(Error::data_length));
  for (std::size_t at = 0; at < rest.size(); at += length + 1) {
    if (Device* const device = find(rest[at])) {
      counted(device->write(number(parameters, 0), rest.subspan(at + 1, length), time));
    }
  }
}

void Bus::bulk_read(Octets parameters, Time time) {
  constexpr std::size_t entry = 1 + range_octets;
  if (parameters.empty() || parameters.size() % entry != 0) return void(counted(Error::data_length));
  for (std::size_t at = 0; at < parameters.size(); at += entry) {
    const std::uint8_t id = parameters[at];
    if (Device* const device = find(id)) read(id, *device, parameters.subspan(at + 1, range_octets), time);
  }
}

void Bus::bulk_write(Octets parameters, Time time) {
  while (!parameters.empty()) {
    constexpr std::size_t head = 1 + range_octets;
    const std::size_t length = parameters.size() < head ? 0 : number(parameters, 3);
    if (length == 0 || parameters.size() < head + length) return void(counted(Error::data_length));
    if (Device* const device = find(parameters[0])) {
      counted(device->write(number(parameters, 1), parameters.subspan(head, length), time));
    }
    parameters = parameters.subspan(head + length);
  }
}

Device* Bus::find(std::uint8_t id) {
  if (board_ && id == settings_.board->id) return board_.get();
  const auto servo = servos_.find(id);
  return servo == servos_.end() ? nullptr : &servo->second;
}

void Bus::answer(std::uint8_t id, const Device& device, Error error, Octets values, Time time) {
  const auto number = static_cast<std::uint8_t>(static_cast<std::uint8_t>(error) | (device.alert() ? alert_bit : 0));
  answers_.push_back({encode_status(id, number, values), time, device.return_delay()});
}

Error Bus::counted(Error error) {
  if (error != Error::none) recorder_->refused(name(error));
  return error;
}

std::uint8_t Bus::contacts() const {
  unsigned bits = 0;
  for (const FootSwitch& foot : settings_.feet) {
    if (foot.closed_at(servos_.at(foot.servo).position())) bits |= 1U << foot.input;
  }
  return static_cast<std::uint8_t>(bits);
}

void Bus::advance(Time time) {
  while (time - advanced_ >= tick) {
    if (std::ranges::all_of(servos_, [](const auto& servo) { return servo.second.at_rest(); })) {
      advanced_ += (time - advanced_) / tick * tick;
      for (auto& [id, servo] : servos_) servo.follow(advanced_);
      return;
    }
    advanced_ += tick;
    for (auto& [id, servo] : servos_) servo.follow(advanced_);
  }
}

Servo& Bus::existing(unsigned servo) {
  const auto found = servos_.find(servo);
  if (found == servos_.end()) throw std::invalid_argument("no servo '" + std::to_string(servo) + "'");
  return found->second;
}

void Bus::overload(unsigned servo, bool on, Time time) {
  Servo& device = existing(servo);
  advance(time);
  device.overload(on, time);
}

void Bus::place(unsigned servo, double position, Time time) {
  Servo& device = existing(servo);
  if (device.torque()) throw std::invalid_argument("servo " + std::to_string(servo) + " is on and holds its position");
  constexpr double highest = 4095;
  if (!(position >= 0 && position <= highest)) throw std::invalid_argument("a servo's position is in 0..4095");
  advance(time);
  device.place(position);
}

void Bus::reset(Time time) {
  advance(time);
  for (auto& [id, servo] : servos_) servo.power_cycle(time);
  decoder_.clear();
  answers_.clear();
}

nlohmann::json Bus::state(Time time) {
  advance(time);
  auto servos = nlohmann::json::object();
  for (const auto& [id, servo] : servos_) servos[std::to_string(id)] = servo.state();
  auto contacts = nlohmann::json::object();
  for (const FootSwitch& foot : settings_.feet) {
    contacts[std::to_string(foot.input)] = foot.closed_at(servos_.at(foot.servo).position());
  }
  return {{"servos", servos}, {"contacts", contacts}};
}

}  // namespace lamprey::robot_bridge::emulators::dynamixel
