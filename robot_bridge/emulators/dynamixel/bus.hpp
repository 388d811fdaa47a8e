#pragma once

#include "robot_bridge/emulators/controller.hpp"
#include "robot_bridge/emulators/dynamixel/contact_board.hpp"
#include "robot_bridge/emulators/dynamixel/packet.hpp"
#include "robot_bridge/emulators/dynamixel/servo.hpp"
#include "robot_bridge/emulators/foot_switch.hpp"
#include "robot_bridge/emulators/recorder.hpp"

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

namespace lamprey::robot_bridge::emulators::dynamixel {

struct Board {
  std::uint8_t id;
  std::uint16_t address;
};

struct Settings {
  std::vector<std::uint8_t> servos;  ///< ids, each once
  ServoSettings servo;               ///< what they have in common
  std::vector<FootSwitch> feet;      ///< their servos are among `servos`
  std::optional<Board> board;        ///< with an id of its own
};

/// DYNAMIXEL servos on one bus, and a board with the feet's contacts.
class Bus : public Controller {
 public:
  /// `recorder` outlives it; `now` is when it gets its power.
  Bus(const Settings& settings, Recorder& recorder, Time now);
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  void receive(std::uint8_t octet, Time time) override;
  std::vector<Answer> take_answers() override;
  void disconnected() override { decoder_.clear(); }
  void overload(unsigned servo, bool on, Time time) override;
  void place(unsigned servo, double position, Time time) override;
  void reset(Time time) override;
  nlohmann::json state(Time time) override;

 private:
  using Octets = std::span<const std::uint8_t>;
  void advance(Time time);
  void handle(const Packet& packet, Time time);
  void handle_for_all(const Packet& packet, Time time);
  void handle_for_one(std::uint8_t id, Device& device, const Packet& packet, bool answers, Time time);
  void ping(std::uint8_t id, const Device& device, Time time);
  void read(std::uint8_t id, Device& device, Octets parameters, Time time);
  void sync_read(Octets parameters, Time time);
  void sync_write(Octets parameters, Time time);
  void bulk_read(Octets parameters, Time time);
  void bulk_write(Octets parameters, Time time);
  Device* find(std::uint8_t id);
  void answer(std::uint8_t id, const Device& device, Error error, Octets values, Time time);
  Error counted(Error error);
  std::uint8_t contacts() const;
  Servo& existing(unsigned servo);

  Settings settings_;
  Recorder* recorder_;
  std::map<unsigned, Servo> servos_;
  std::unique_ptr<ContactBoard> board_;
  Decoder decoder_;
  std::vector<Answer> answers_;
  Time advanced_;  ///< the last tick
};

/// The value of the baud rate register for a speed; nothing for those that X servos do not have.
std::optional<std::uint8_t> baud_register(unsigned baud);

}  // namespace lamprey::robot_bridge::emulators::dynamixel
