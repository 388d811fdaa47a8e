// A program that does one thing with one topic, until it is killed: the conformance tests stop and end it, and cut it
// off from others.
//
//   lamprey_conformance_program VENDOR DOMAIN ISOLATION NETWORK lease|result RECEIVER ACTION
//
// NETWORK: "loopback", "multicast" or the address of a peer. RECEIVER: of the partition; 0 for the common one. ACTION:
//   read                      says the number of each sample that it takes
//   read-once                 says the number of the first, and never takes again
//   join-crowd COUNT          of leases: tells of itself as a worker, waits until it knows of COUNT workers, then says
//                             the number of each lease that it takes and acknowledges it to all
//   write FIRST LAST PERIOD   writes samples with these numbers, one each PERIOD milliseconds, the same one again while
//                             the writer is full; then says LAST
// What it says are lines of its standard output.
#include "messaging/port.hpp"
#include "tests/conformance/numbered.hpp"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <sys/prctl.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace {

using namespace lamprey::messaging;

void say(std::uint64_t number) {
  std::printf("%llu\n", static_cast<unsigned long long>(number));
  std::fflush(stdout);
}

template <class Sample>
[[noreturn]] void read(Participant& participant, Partition partition, bool once) {
  const auto signal = std::make_shared<Signal>();
  const auto reader = participant.reader<Sample>(signal, partition);
  for (;;) {
    for (const auto& sample : reader->take(once ? 1 : 4096)) {
      say(conformance::number_of(sample));
      while (once) pause();
    }
    signal->wait_for(std::chrono::seconds(1));
  }
}

template <class Sample>
[[noreturn]] void write(Participant& participant, Partition partition, std::span<const std::string> numbers) {
  if (numbers.size() != 3) throw std::invalid_argument("write FIRST LAST PERIOD");
  const auto first = std::stoull(numbers[0]);
  const auto last = std::stoull(numbers[1]);
  const std::chrono::milliseconds period(std::stoull(numbers[2]));
  const auto writer = participant.writer<Sample>(partition);
  auto due = std::chrono::steady_clock::now();
  for (auto number = first; number <= last; ++number) {
    std::this_thread::sleep_until(due);
    due += period;
    WriteResult result = writer->write(conformance::numbered<Sample>(number));
    while (result.kind == WriteResult::Kind::full) result = writer->write(conformance::numbered<Sample>(number));
    if (!result) throw std::runtime_error(result.error);
  }
  say(last);
  for (;;) pause();
}

[[noreturn]] void join_crowd(Participant& participant, Partition partition, std::size_t count) {
  const auto signal = std::make_shared<Signal>();
  const auto statuses = participant.reader<WorkerStatus>(signal);
  const auto leases = participant.reader<Lease>(signal, partition);
  const auto status = participant.writer<WorkerStatus>();
  const auto acknowledgements = participant.writer<ResultAcknowledgement>();
  const auto write = [](auto& writer, const auto& sample) {
    if (const WriteResult result = writer.write(sample); !result) throw std::runtime_error(result.error);
  };
  write(*status, conformance::numbered<WorkerStatus>(1, partition.receiver));
  for (std::set<std::uint64_t> known; known.size() < count; signal->wait_for(std::chrono::seconds(1))) {
    for (const auto& other : statuses->take()) known.insert(other.origin.worker);
  }
  for (;;) {
    for (const auto& lease : leases->take()) {
      say(conformance::number_of(lease));
      write(*acknowledgements, conformance::numbered<ResultAcknowledgement>(conformance::number_of(lease)));
    }
    signal->wait_for(std::chrono::seconds(1));
  }
}

template <class Sample>
[[noreturn]] void act(Participant& participant, Partition partition, std::span<const std::string> action) {
  if (action[0] == "write") write<Sample>(participant, partition, action.subspan(1));
  if (action[0] != "read" && action[0] != "read-once") throw std::invalid_argument("no such action: " + action[0]);
  read<Sample>(participant, partition, action[0] == "read-once");
}

JoinOptions options_of(std::span<const std::string> words) {
  JoinOptions options;
  options.vendor = words[0];
  options.domain = static_cast<std::uint32_t>(std::stoul(words[1]));
  options.isolation = words[2];
  options.loopback_only = words[3] == "loopback";
  if (words[3] != "loopback" && words[3] != "multicast") options.peers = {words[3]};
  return options;
}

}  // namespace

int main(int count, char** arguments) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // not to outlive the test, even while it is stopped
  const std::vector<std::string> words(arguments + 1, arguments + count);
  if (words.size() < 7) return 2;
  try {
    const auto participant = join(options_of(words));
    const auto partition = Partition::of(std::stoull(words[5]));
    const auto action = std::span(words).subspan(6);
    if (action[0] == "join-crowd") join_crowd(*participant, partition, std::stoull(words.at(7)));
    if (words[4] == "lease") act<Lease>(*participant, partition, action);
    if (words[4] == "result") act<ResultBatch>(*participant, partition, action);
    throw std::invalid_argument("no such topic: " + words[4]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
