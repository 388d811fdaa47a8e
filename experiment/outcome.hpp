#pragma once

#include "experiment/identifiers.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lamprey::experiment {

/// Fitness of one evaluation: S (eq. 7.5), D (eq. 7.7) and F (eq. 7.9) as they are, and their weighted total (eq. 7.4).
struct Score {
  double stability = 0;
  double distance = 0;
  double fuel = 0;
  double total = 0;

  bool operator==(const Score&) const = default;
};

/// One accepted change: after `cycle` (0-based) the system had this score.
struct AcceptedChange {
  std::uint32_t cycle = 0;
  Score score;

  bool operator==(const AcceptedChange&) const = default;
};

/// The longest name of a measure.
inline constexpr std::size_t maximum_measure_name = 64;

/// A number that only some jobs have: recovery after a change of environment, failures before a change of gait, the
/// variation of the parameters. docs/formats/measures.md lists the names.
struct Measure {
  std::string name;         ///< [a-z_0-9]+, at most maximum_measure_name characters
  std::uint32_t index = 0;  ///< of the change, cycle or generation that it is about; unique per name
  double value = 0;         ///< finite, not −0

  bool operator==(const Measure&) const = default;
};

/// What a finished job is stored as. Every field is deterministic and covered by the digest.
struct Outcome {
  Score expected;  ///< of the undisturbed gait
  Score initial;   ///< after the disturbance, before the first mutation
  Score evolved;  ///< of the accepted state nearest to `expected` (smallest summed weighted error; the first of equals)
  Score highest;  ///< the highest total among the accepted states (the first of equals)
  Score final;    ///< of the last accepted state
  std::uint32_t cycles = 0;           ///< mutations tried
  std::uint32_t accepted = 0;         ///< mutations kept: the number of rows of the trace
  std::uint32_t successes = 0;        ///< mutations that the criterion calls better than the last accepted state
  double success_rate = 0;            ///< eq. 8.1: successes / cycles
  std::vector<AcceptedChange> trace;  ///< in order of cycle
  std::vector<Measure> measures{};    ///< sorted by name and index; empty for most jobs

  bool operator==(const Outcome&) const = default;
};

/// What is wrong with a job's measures: a name, a value, their order; empty if nothing is.
std::string measures_fault(std::span<const Measure> measures);

/// SHA-256 over the identity and every field of the outcome (docs/formats/digest.md). Equal digests, equal bits.
Digest outcome_digest(const Digest& identity, const Outcome& outcome);

}  // namespace lamprey::experiment
