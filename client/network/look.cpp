#include "client/network/look.hpp"

#include "client/coordinator_connection.hpp"

#include <chrono>
#include <thread>

namespace lamprey::client::network {

namespace {

std::unique_ptr<messaging::discovery::Watch> watch(const messaging::JoinOptions& join, const Environment& environment) {
  try {
    return environment.watch(join);
  } catch (const messaging::JoinError& error) {
    throw Failure(exit_unreachable, "cannot_join", error.what());
  }
}

}  // namespace

messaging::discovery::DomainView look(const messaging::JoinOptions& join, double seconds,
                                      const Environment& environment) {
  const auto watching = watch(join, environment);
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < until) {
    if (environment.interrupted()) throw interrupted_failure();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return watching->look();
}

}  // namespace lamprey::client::network
