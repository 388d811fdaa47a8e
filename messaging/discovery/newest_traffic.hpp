#pragma once

#include "messaging/traffic.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace lamprey::messaging::discovery {

/// Keeps the newest counts of each participant that has told any, up to so many: what comes from the network names
/// participants as it likes.
class NewestTraffic {
 public:
  static constexpr std::size_t most_participants = 65'536;

  /// Takes in what has come, in the order in which it came; all that is known then, by participant.
  std::vector<Traffic> after(std::vector<Traffic> arrived);

 private:
  std::map<std::array<std::uint8_t, 16>, Traffic> newest_;
};

}  // namespace lamprey::messaging::discovery
