// A reader of results that says so once it has got the first, and then never takes again: to be killed or stopped by a
// test. Usage: VENDOR DOMAIN ISOLATION.
#include "messaging/port.hpp"

#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <unistd.h>

int main(int count, char** arguments) {
  using namespace lamprey::messaging;
  if (count != 4) return 2;
  try {
    const auto participant = join({.vendor = arguments[1],
                                   .domain = static_cast<std::uint32_t>(std::stoul(arguments[2])),
                                   .isolation = arguments[3],
                                   .peers = {},
                                   .loopback_only = true});
    const auto signal = std::make_shared<Signal>();
    const auto reader = participant->reader<ResultBatch>(signal);
    while (reader->take(1).empty()) signal->wait_for(std::chrono::seconds(1));
    std::puts("ready");
    std::fflush(stdout);
    for (;;) pause();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
