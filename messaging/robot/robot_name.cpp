#include "messaging/robot/robot_name.hpp"

#include "experiment/identifiers.hpp"
#include "messaging/names.hpp"

namespace lamprey::messaging {

std::uint64_t robot_number(std::string_view name) {
  return experiment::leading_128_bits(experiment::sha256(name)).high;
}

bool is_valid_robot(std::string_view name) {
  return is_valid_isolation(name);
}

}  // namespace lamprey::messaging
