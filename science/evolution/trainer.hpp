#pragma once

#include "science/evolution/objective.hpp"
#include "science/evolution/problem.hpp"
#include "science/random/stream.hpp"
#include "science/saving/archive.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace lamprey::science::evolution {

/// What every trainer is given besides its own settings. Refers to the problem, which must outlive it.
struct Training {
  const Problem& problem;
  fitness::Environment environment;
  Objective objective = Objective::target;
  fitness::Fitness expected;  ///< what `target` aims at in this environment
  random::Stream stream;
};

inline Errors errors(const Training& training, const fitness::Fitness& value) {
  return errors(training.objective, training.environment.weights, training.expected, value);
}

/// What trainers that compare whole errors minimise: the summed weighted error (3.4.2).
inline double cost(const Training& training, const fitness::Fitness& value) {
  return total(errors(training, value));
}

/// What one evaluation did.
struct CycleReport {
  fitness::Fitness fitness;  ///< of the candidate
  bool accepted = false;     ///< on-line: it is the robot's state now. Off-line: it is the best so far
  bool success = false;      ///< it is better than the last accepted state (eq. 8.1)
};

/// A number that a trainer has to tell besides its reports.
struct Measure {
  std::string_view name;
  std::uint32_t index = 0;
  double value = 0;
};

/// A trainer with its state between two steps. Deterministic: with what it is given, the state decides all that
/// follows.
class Trainer {
 public:
  virtual ~Trainer() = default;

  /// Takes its first genes and tries them once from standing; no cycle is counted. Off-line trainers call this their
  /// first candidate. Called once, before anything else.
  virtual fitness::Fitness begin(const Training& training) = 0;

  /// One step, a mutation or a generation, of at least one and at most `budget` evaluations (≥ 1), each with a report
  /// appended. A generation that the budget cuts short goes on with the next call: what is tried, and in which order,
  /// never depends on how evaluations are portioned.
  virtual void advance(const Training& training, std::uint32_t budget, std::vector<CycleReport>& reports) = 0;

  /// The genes of the last accepted state.
  virtual std::span<const double> genes() const = 0;

  /// The environment is another from now on: tries the last accepted genes once in it, and gives their fitness. No
  /// cycle is counted. Off-line trainers know one environment and throw std::logic_error.
  virtual fitness::Fitness meet(const Training& training);

  /// All of them so far.
  virtual std::vector<Measure> measures() const { return {}; }

  /// Whether save and restore are for this trainer; if not, they throw std::logic_error.
  virtual bool can_be_saved() const { return false; }

  /// Everything that decides what follows, unless the settings, the problem or the number of cycles give it.
  virtual void save(const Training& training, saving::Writer& writer) const;

  /// Instead of begin(): goes on where a trainer of the same settings, problem and training was saved after `cycles`
  /// cycles. Throws saving::Invalid for what cannot be its state; it is of no use then.
  virtual void restore(const Training& training, std::uint32_t cycles, saving::Reader& reader);

  virtual std::unique_ptr<Trainer> clone() const = 0;
};

}  // namespace lamprey::science::evolution
