#pragma once

#include "robot_bridge/emulators/descriptor.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lamprey::robot_bridge::emulators {

/// A pseudo-terminal whose slave a link leads to, as an adapter's device file would. The slave is held open, so that
/// nothing is lost when its user closes and opens it again, and is raw from the beginning.
class PseudoTerminal {
 public:
  /// Makes the link, in place of a symbolic link that leads nowhere or to another terminal. Throws
  /// std::invalid_argument if something else is there or no link can be made, std::system_error if the system has no
  /// pseudo-terminal for us.
  PseudoTerminal(std::string link, unsigned baud);
  /// Hangs up on whoever uses the slave, and takes the link away if it still leads here.
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// To wait for.
  int descriptor() const { return master_.get(); }
  const std::string& slave_name() const { return slave_name_; }

  /// What its user has written, as far as it fits the buffer; does not wait.
  std::span<const std::uint8_t> read(std::span<std::uint8_t> buffer);
  /// Returns how many octets found room; does not wait.
  std::size_t write(std::span<const std::uint8_t> octets);
  /// Whether its user has chosen another speed than the controller's.
  bool at_another_speed() const;

 private:
  std::string link_;
  Descriptor master_;
  Descriptor slave_;
  std::string slave_name_;
  unsigned long speed_;  ///< the system's name for the controller's; 0 where it has none
};

}  // namespace lamprey::robot_bridge::emulators
