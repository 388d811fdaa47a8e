#include "robot_bridge/emulators/dynamixel/contact_board.hpp"

#include <utility>

namespace lamprey::robot_bridge::emulators::dynamixel {
namespace {

constexpr std::int64_t model_of_the_board = 60000;
constexpr std::int64_t firmware_of_the_board = 1;

}  // namespace

ContactBoard::ContactBoard(std::uint8_t id, std::uint8_t baud_register, std::uint16_t address,
                           std::function<std::uint8_t()> contacts)
    : items_{{model_number, 2, false, model_of_the_board, 0, 0xFFFF},
             {firmware_version, 1, false, firmware_of_the_board, 0, 0xFF},
             {id_number, 1, false, id, 0, highest_id},
             {baud_rate, 1, false, baud_register, 0, 7},
             {return_delay_time, 1, true, 250, 0, 254},
             {address, 1, false, 0, 0, 0xFF}},
      table_(items_),
      address_(address),
      contacts_(std::move(contacts)) {}

std::uint16_t ContactBoard::model() const {
  return static_cast<std::uint16_t>(table_.get(model_number));
}

std::uint8_t ContactBoard::firmware() const {
  return static_cast<std::uint8_t>(table_.get(firmware_version));
}

Time ContactBoard::return_delay() const {
  return table_.get(return_delay_time) * Time{std::chrono::microseconds{2}};
}

Error ContactBoard::read(std::uint16_t address, std::uint16_t octets, std::vector<std::uint8_t>& values) {
  table_.set(address_, contacts_());
  return table_.read(address, octets, values);
}

Error ContactBoard::write(std::uint16_t address, std::span<const std::uint8_t> octets, Time) {
  std::vector<std::uint16_t> written;
  return table_.write(
      address, octets, [](const Item&, std::int64_t) { return Error::none; }, written);
}

}  // namespace lamprey::robot_bridge::emulators::dynamixel
