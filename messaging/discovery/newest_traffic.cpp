#include "messaging/discovery/newest_traffic.hpp"

#include <utility>

namespace lamprey::messaging::discovery {

std::vector<Traffic> NewestTraffic::after(std::vector<Traffic> arrived) {
  for (auto& traffic : arrived) {
    if (newest_.size() >= most_participants && !newest_.contains(traffic.participant)) continue;
    newest_.insert_or_assign(traffic.participant, std::move(traffic));
  }
  std::vector<Traffic> all;
  for (const auto& [participant, traffic] : newest_) all.push_back(traffic);
  return all;
}

}  // namespace lamprey::messaging::discovery
