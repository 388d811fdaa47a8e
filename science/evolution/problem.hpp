#pragma once

#include "science/evolution/gene_plan.hpp"
#include "science/fitness/environment.hpp"
#include "science/robots/recording.hpp"
#include "science/saving/archive.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace lamprey::science::evolution {

/// All that lives on from one evaluation to the next where a robot walks on: posture, clocks, pending windows. A fresh
/// one stands, with clocks at zero. A value; what is in it only its problem knows.
class Body {
 public:
  /// What was put; a default `State` if nothing was.
  template <typename State>
  State get() const {
    static_assert(std::is_trivially_copyable_v<State>);
    State state{};
    if (!bytes_.empty()) std::memcpy(static_cast<void*>(&state), bytes_.data(), sizeof state);
    return state;
  }
  template <typename State>
  void put(const State& state) {
    static_assert(std::is_trivially_copyable_v<State>);
    bytes_.resize(sizeof state);
    std::memcpy(bytes_.data(), static_cast<const void*>(&state), sizeof state);
  }
  /// Stands again.
  void reset() { bytes_.clear(); }

 private:
  std::vector<std::byte> bytes_;
};

/// What a trainer tunes: a bounded vector of genes, tried with a body in an environment. Immutable; any thread.
class Problem {
 public:
  virtual ~Problem() = default;

  virtual const GenePlan& plan() const = 0;

  /// The genes of the undisturbed gait; empty where the thesis has none and a trainer starts at random (6.2.2.4).
  virtual std::span<const double> preset() const = 0;

  /// One evaluation from where `body` is, which is left where it ends. `genes` are as many as the plan has.
  virtual fitness::Fitness evaluate(std::span<const double> genes, const fitness::Environment& environment,
                                    Body& body) const = 0;

  /// A body as octets, and back, the same on any machine; what is read is checked (saving::Invalid).
  virtual void save(const Body& body, saving::Writer& writer) const = 0;
  virtual void restore(saving::Reader& reader, Body& body) const = 0;

  /// What the objective `target` aims at: the fitness of the wanted gait from standing in that environment (8.2.3).
  virtual fitness::Fitness expected(const fitness::Environment& environment) const = 0;

  /// `time_steps` steps from standing, step by step.
  virtual robots::Recording record(std::span<const double> genes, const fitness::Environment& environment,
                                   std::int32_t time_steps) const = 0;
};

}  // namespace lamprey::science::evolution
