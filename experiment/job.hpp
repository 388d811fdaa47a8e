#pragma once

#include "experiment/identifiers.hpp"
#include "experiment/parameters.hpp"

#include <cstdint>

namespace lamprey::experiment {

/// One experiment: what an outcome is a pure function of (with the science version). The number is only its address
/// within a sweep and changes nothing.
struct Job {
  std::uint64_t number = 0;  ///< 0-based, within its sweep
  std::uint64_t seed = 0;
  std::uint32_t replicate = 0;
  Parameters parameters;
};

/// SHA-256 over science version, seed, replicate and canonical parameters (docs/formats/identity.md).
Digest identity(const Job& job);

/// The Philox key of the job's random streams: from the same fields without the science version, so that a new science
/// version meets the same draws. A job on a robot has the key of the same job in simulation.
std::uint64_t stream_key(const Job& job);

}  // namespace lamprey::experiment
