#include "client/network/look.hpp"

#include "client/coordinator_connection.hpp"

#include <chrono>
#include <thread>
#include <vector>

namespace lamprey::client::network {

namespace {

std::unique_ptr<messaging::discovery::Watch> watch(const messaging::JoinOptions& join, const Environment& environment) {
  try {
    return environment.watch(join);
  } catch (const messaging::JoinError& error) {
    throw Failure(exit_unreachable, "cannot_join", error.what());
  }
}

/// Looks are dear in a large domain; programs tell of their traffic each second.
constexpr std::chrono::milliseconds look_interval{500};

void note_first(const std::vector<messaging::Traffic>& seen, FirstTraffic& first) {
  for (const auto& traffic : seen) first.try_emplace(traffic.participant, traffic);
}

}  // namespace

Sight look(const messaging::JoinOptions& join, double seconds, const Environment& environment) {
  using Clock = std::chrono::steady_clock;
  const auto watching = watch(join, environment);
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  auto due = Clock::now() + look_interval;
  Sight sight;
  while (Clock::now() < until) {
    if (environment.interrupted()) throw interrupted_failure();
    if (Clock::now() >= due) {
      due += look_interval;
      note_first(watching->look().traffic, sight.first);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  sight.view = watching->look();
  note_first(sight.view.traffic, sight.first);
  return sight;
}

}  // namespace lamprey::client::network
