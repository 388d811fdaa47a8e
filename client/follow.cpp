#include "client/follow.hpp"

#include <algorithm>

namespace lamprey::client {

void follow(CoordinatorConnection& connection, const Following& following) {
  constexpr std::chrono::milliseconds look_interval{50};
  auto& client = connection.client();
  const auto begin = Clock::now();
  std::optional<experiment::Id128> database;
  Clock::time_point asked = begin;
  Clock::time_point due = begin;
  while (true) {
    const auto now = Clock::now();
    if (connection.interrupted()) throw interrupted_failure();
    if (!client.waiting() && now >= due) {
      client.begin(following.ask(), now);
      asked = now;
    }
    if (const auto reply = client.poll(now)) {
      if (!database) database = client.answered_by().database;
      // Of two coordinators on one network the first to answer is the one that is meant.
      if (client.answered_by().database == *database) {
        require_success(*reply);
        const auto pause = following.take(*reply);
        if (!pause) return;
        due = now + *pause;
      }
    }
    if (!database && now - begin >= connection.timeout()) throw connection.unreachable();
    if (following.meanwhile) following.meanwhile(now, client.waiting() ? now - asked : Clock::duration{});
    const auto until_due = std::chrono::ceil<std::chrono::milliseconds>(due - now);
    const bool at_once = !client.waiting() && until_due.count() <= 0;
    if (!at_once) {
      connection.signal()->wait_for(client.waiting() ? look_interval : std::min(look_interval, until_due));
    }
  }
}

}  // namespace lamprey::client
