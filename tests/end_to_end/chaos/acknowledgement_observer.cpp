// Listens to what the coordinator acknowledges to workers, and writes a line for each result:
// "<sweep, 32 hex digits> <job> <verdict>".
//
//   lamprey_acknowledgement_observer VENDOR ISOLATION     until standard input ends
#include "messaging/port.hpp"
#include "messaging/samples.hpp"

#include <array>
#include <chrono>
#include <exception>
#include <iostream>
#include <map>
#include <memory>
#include <poll.h>
#include <unistd.h>

namespace {

using namespace lamprey;

constexpr std::array verdicts{"committed", "duplicate", "divergent", "refused"};

bool input_has_ended() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return ::poll(&input, 1, 0) != 0;
}

void listen(const messaging::JoinOptions& options) {
  auto signal = std::make_shared<messaging::Signal>();
  const auto participant = messaging::join(options);
  const auto statuses = participant->reader<messaging::WorkerStatus>(signal);
  std::map<std::uint64_t, std::unique_ptr<messaging::Reader<messaging::ResultAcknowledgement>>> workers;
  while (!input_has_ended()) {
    signal->wait_for(std::chrono::milliseconds{50});
    for (const auto& status : statuses->take(1000)) {
      auto& reader = workers[status.origin.worker];
      if (reader != nullptr) continue;
      reader =
          participant->reader<messaging::ResultAcknowledgement>(signal, messaging::Partition::of(status.origin.worker));
    }
    for (const auto& [worker, reader] : workers) {
      for (const auto& sample : reader->take(1000)) {
        for (const auto& answer : sample.results) {
          std::cout << experiment::to_hex(answer.sweep) << ' ' << answer.job << ' '
                    << verdicts.at(static_cast<std::size_t>(answer.verdict)) << '\n';
        }
      }
    }
    std::cout << std::flush;
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::cerr << "usage: lamprey_acknowledgement_observer VENDOR ISOLATION\n";
    return 2;
  }
  try {
    messaging::JoinOptions options;
    options.vendor = arguments[1];
    options.isolation = arguments[2];
    options.loopback_only = true;
    listen(options);
  } catch (const std::exception& error) {
    std::cerr << "lamprey_acknowledgement_observer: " << error.what() << '\n';
    return 1;
  }
}
