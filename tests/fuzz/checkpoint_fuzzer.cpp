// Any octets as the checkpoint of a job: refused with a reason, or a run that goes on to its end. The mutator mends the
// CRC, so that fuzzing gets past it.
#include "experiment/checkpoint.hpp"
#include "experiment/sweep.hpp"
#include "idl/checkpoint.pb.h"
#include "tests/fuzz/fuzzing.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/crc.hpp>
#include <string>
#include <vector>

namespace {

using namespace lamprey;
using fuzzing::require;

constexpr std::size_t crc_octets = 4;

/// One of each kind of trainer, robot and environment that is quick.
const experiment::SweepGrid& grid() {
  static const experiment::SweepGrid jobs(
      experiment::parse_sweep("name: fuzz\nseed: 1\nbase: {cycles: 40}\ngrids:\n"
                              "  - {mutation: [all, one], acceptance: [simple, annealing], steps: [uniform, "
                              "one_fifth_rule], posture: [reset, carry]}\n",
                              "")
          .specification);
  return jobs;
}

void look_at(const experiment::Job& job, std::span<const std::uint8_t> octets) {
  using namespace experiment;
  try {
    const auto head = read_checkpoint_head(octets);
    const auto trace = read_checkpoint_trace(octets);
    for (const auto& change : trace) require(change.cycle < head.cycle);
    auto [run, seconds] = resume(job, octets);
    require(head.identity == identity(job) && seconds == head.seconds);
    require(run.outcome().trace == trace && run.outcome().cycles == head.cycle);
    // What is resumed and saved again says the same as before.
    if (!run.finished()) {
      const auto saved = write_checkpoint(run, job, seconds);
      require(!saved.empty() && read_checkpoint_head(saved).cycle == head.cycle);
      require(read_checkpoint_trace(saved) == trace);
    }
    while (!run.finished()) run.advance();
    require(run.outcome().cycles == static_cast<std::uint32_t>(job.parameters.integer("cycles")));
    if (!fuzzing::reached<1>(seconds > 1000)) return;
    if (fuzzing::reached<2>(!trace.empty())) fuzzing::planted_bug();
  } catch (const CheckpointError& error) {
    require(error.what()[0] != '\0');
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  look_at(grid().job(*data % grid().jobs()), {data + 1, size - 1});
  return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

#ifdef LAMPREY_FUZZING
namespace {

std::size_t close_with_crc(std::uint8_t* body, std::size_t size) {
  boost::crc_optimal<32, 0x1EDC6F41, 0xFFFFFFFF, 0xFFFFFFFF, true, true> crc;
  crc.process_bytes(body, size);
  for (std::size_t i = 0; i < crc_octets; ++i) body[size + i] = static_cast<std::uint8_t>(crc.checksum() >> (8 * i));
  return size + crc_octets;
}

/// A field of the message, as octets, mutated in place of the whole: protobuf's own lengths stay right.
std::string mutated(const std::string& octets) {
  std::vector<std::uint8_t> room(octets.begin(), octets.end());
  room.resize(octets.size() + 32);
  const auto size = LLVMFuzzerMutate(room.data(), octets.size(), room.size());
  return {room.begin(), room.begin() + static_cast<std::ptrdiff_t>(size)};
}

double mutated(double value) {
  std::array<std::uint8_t, sizeof value> octets = std::bit_cast<std::array<std::uint8_t, sizeof value>>(value);
  LLVMFuzzerMutate(octets.data(), octets.size(), octets.size());
  return std::bit_cast<double>(octets);
}

void mutate_row(idl::Checkpoint& message, unsigned seed) {
  const int rows = std::min(message.trace_cycle_size(), message.trace_fuel_size());
  if (rows == 0) {
    message.set_cycle(seed % 48);
    return;
  }
  const int row = static_cast<int>(seed % static_cast<unsigned>(rows));
  if (seed % 2 == 0) {
    message.set_trace_cycle(row, seed / 64 % 48);
  } else {
    message.set_trace_fuel(row, mutated(message.trace_fuel(row)));
  }
}

std::size_t mutate_fields(std::uint8_t* body, std::size_t size, std::size_t most, unsigned seed) {
  idl::Checkpoint message;
  if (!message.ParseFromArray(body, static_cast<int>(size))) return LLVMFuzzerMutate(body, size, most);
  switch (seed % 4) {
    case 0:
      message.set_trainer(mutated(message.trainer()));
      break;
    case 1:
      message.set_recorder(mutated(message.recorder()));
      break;
    case 2:
      message.set_seconds(mutated(message.seconds()));
      break;
    default:
      mutate_row(message, seed / 4);
      break;
  }
  if (message.ByteSizeLong() > most) return size;
  message.SerializeToArray(body, static_cast<int>(message.ByteSizeLong()));
  return message.ByteSizeLong();
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  // Sometimes the CRC itself, and what stands before everything.
  if (seed % 16 == 0 || size < 1 + crc_octets || most < size + 64) return LLVMFuzzerMutate(data, size, most);
  std::uint8_t* const body = data + 1;
  const std::size_t body_size = size - 1 - crc_octets;
  const std::size_t room = most - 1 - crc_octets;
  const std::size_t mutated_size =
      seed % 4 == 1 ? LLVMFuzzerMutate(body, body_size, room) : mutate_fields(body, body_size, room, seed / 16);
  return 1 + close_with_crc(body, mutated_size);
}
#endif
