#include "experiment/checkpoint.hpp"

#include "experiment/identifiers.hpp"
#include "idl/checkpoint.pb.h"

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace lamprey::experiment {

namespace {

constexpr std::uint32_t format_version = 1;

/// G. Castagnoli's polynomial, as in iSCSI, ext4 and others.
using Crc32c = boost::crc_optimal<32, 0x1EDC6F41, 0xFFFFFFFF, 0xFFFFFFFF, true, true>;
constexpr std::size_t crc_octets = 4;

/// Of the trace, without the cycle's: what is sure to be written of a row.
constexpr std::size_t least_octets_per_row = 4 * sizeof(double) + 1;

std::uint32_t crc_of(std::span<const std::uint8_t> octets) {
  Crc32c crc;
  crc.process_bytes(octets.data(), octets.size());
  return crc.checksum();
}

std::array<std::uint8_t, crc_octets> little_endian(std::uint32_t word) {
  std::array<std::uint8_t, crc_octets> octets{};
  for (std::size_t i = 0; i < octets.size(); ++i) octets[i] = static_cast<std::uint8_t>(word >> (8 * i));
  return octets;
}

void put_trace(std::span<const AcceptedChange> trace, idl::Checkpoint& message) {
  const int rows = static_cast<int>(trace.size());
  message.mutable_trace_cycle()->Reserve(rows);
  for (auto* column : {message.mutable_trace_stability(), message.mutable_trace_distance(),
                       message.mutable_trace_fuel(), message.mutable_trace_total()}) {
    column->Reserve(rows);
  }
  for (const auto& [cycle, score] : trace) {
    message.add_trace_cycle(cycle);
    message.add_trace_stability(score.stability);
    message.add_trace_distance(score.distance);
    message.add_trace_fuel(score.fuel);
    message.add_trace_total(score.total);
  }
}

bool is_finite(const Score& score) {
  return std::isfinite(score.stability) && std::isfinite(score.distance) && std::isfinite(score.fuel) &&
         std::isfinite(score.total);
}

std::vector<AcceptedChange> trace_of(const idl::Checkpoint& message) {
  const int rows = message.trace_cycle_size();
  if (message.trace_stability_size() != rows || message.trace_distance_size() != rows ||
      message.trace_fuel_size() != rows || message.trace_total_size() != rows) {
    throw CheckpointError("the columns of its trace differ in length");
  }
  std::vector<AcceptedChange> trace;
  trace.reserve(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    const AcceptedChange change{.cycle = message.trace_cycle(row),
                                .score = {.stability = message.trace_stability(row),
                                          .distance = message.trace_distance(row),
                                          .fuel = message.trace_fuel(row),
                                          .total = message.trace_total(row)}};
    if (change.cycle >= message.cycle() || (row > 0 && change.cycle <= trace.back().cycle)) {
      throw CheckpointError("row " + std::to_string(row) + " of its trace is of cycle " + std::to_string(change.cycle) +
                            ", out of order or not done yet");
    }
    if (!is_finite(change.score)) {
      throw CheckpointError("row " + std::to_string(row) + " of its trace is not of finite numbers");
    }
    trace.push_back(change);
  }
  return trace;
}

/// The message, whole, of this format and science version, its head checked.
idl::Checkpoint opened(std::span<const std::uint8_t> octets) {
  if (octets.size() > maximum_checkpoint_bytes) {
    throw CheckpointError("it has " + std::to_string(octets.size()) + " octets, at most " +
                          std::to_string(maximum_checkpoint_bytes));
  }
  if (octets.size() <= crc_octets) throw CheckpointError("it has only " + std::to_string(octets.size()) + " octets");
  const auto body = octets.first(octets.size() - crc_octets);
  if (!std::ranges::equal(octets.last(crc_octets), little_endian(crc_of(body)))) {
    throw CheckpointError("its CRC does not agree: it is damaged or cut");
  }
  idl::Checkpoint message;
  if (!message.ParseFromArray(body.data(), static_cast<int>(body.size()))) {
    throw CheckpointError("it cannot be read");
  }
  const auto require_version = [](std::string_view what, std::uint32_t version, std::uint32_t known) {
    if (version == known) return;
    throw CheckpointError("it is of " + std::string(what) + " version " + std::to_string(version) +
                          "; this program has " + std::to_string(known));
  };
  require_version("format", message.format(), format_version);
  require_version("science", message.science_version(), science_version);
  if (message.identity().size() != Digest{}.size()) {
    throw CheckpointError("its identity has " + std::to_string(message.identity().size()) + " octets");
  }
  if (!std::isfinite(message.seconds()) || message.seconds() < 0) {
    throw CheckpointError("its seconds of computation are negative or no number");
  }
  return message;
}

Digest identity_of(const idl::Checkpoint& message) {
  Digest identity{};
  std::ranges::copy(message.identity(), identity.begin());
  return identity;
}

std::vector<std::uint8_t> octets_of(const std::string& bytes) {
  return {bytes.begin(), bytes.end()};
}

std::string bytes_of(const std::vector<std::uint8_t>& octets) {
  return {octets.begin(), octets.end()};
}

}  // namespace

std::vector<std::uint8_t> write_checkpoint(const JobRun& run, const Job& job, double seconds) {
  // Of the trace alone it can be told before it is copied.
  const std::size_t rows = run.outcome().trace.size();
  if (!run.can_be_saved() || rows > maximum_checkpoint_bytes / least_octets_per_row) return {};
  const RunState state = run.save();
  if (state.trainer.size() + state.recorder.size() > maximum_checkpoint_bytes) return {};

  idl::Checkpoint message;
  message.set_format(format_version);
  message.set_science_version(science_version);
  const Digest name = identity(job);
  message.set_identity(std::string(name.begin(), name.end()));
  message.set_cycle(state.cycle);
  message.set_seconds(seconds);
  message.set_trainer(bytes_of(state.trainer));
  message.set_recorder(bytes_of(state.recorder));
  put_trace(state.trace, message);

  const std::size_t size = message.ByteSizeLong();
  if (size + crc_octets > maximum_checkpoint_bytes) return {};
  std::vector<std::uint8_t> octets(size);
  message.SerializeToArray(octets.data(), static_cast<int>(size));
  const auto crc = little_endian(crc_of(octets));
  octets.insert(octets.end(), crc.begin(), crc.end());
  return octets;
}

Resumed resume(const Job& job, std::span<const std::uint8_t> checkpoint) {
  const idl::Checkpoint message = opened(checkpoint);
  if (const Digest wanted = identity(job), got = identity_of(message); got != wanted) {
    throw CheckpointError("it is of the job " + to_hex(got) + ", not of " + to_hex(wanted));
  }
  RunState state{.cycle = message.cycle(),
                 .trainer = octets_of(message.trainer()),
                 .recorder = octets_of(message.recorder()),
                 .trace = trace_of(message)};
  try {
    return {.run = JobRun(job, std::move(state)), .seconds = message.seconds()};
  } catch (const science::saving::Invalid& error) {
    throw CheckpointError(error.what());
  }
}

CheckpointHead read_checkpoint_head(std::span<const std::uint8_t> checkpoint) {
  const idl::Checkpoint message = opened(checkpoint);
  return {.identity = identity_of(message), .cycle = message.cycle(), .seconds = message.seconds()};
}

std::vector<AcceptedChange> read_checkpoint_trace(std::span<const std::uint8_t> checkpoint) {
  return trace_of(opened(checkpoint));
}

}  // namespace lamprey::experiment
