#include "messaging/robot/robot_state.hpp"

#include <array>
#include <cstddef>

namespace lamprey::messaging {

std::string_view to_text(RobotState state) {
  constexpr std::array<std::string_view, 5> texts{"unconfigured", "inactive", "active", "fault", "finalized"};
  return texts.at(static_cast<std::size_t>(state));
}

}  // namespace lamprey::messaging
