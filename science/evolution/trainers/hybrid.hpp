#pragma once

#include "science/evolution/trainer.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace lamprey::science::evolution::trainers {

/// Makes the trainer that goes on from these genes.
using Refinement = std::function<std::unique_ptr<Trainer>(std::vector<double> genes)>;

/// A hybrid algorithm (3.8, fig. 3.15): one trainer has the first evaluations, then another refines the genes that it
/// has come to. The second one's begin() tries those genes once more: like every begin(), this is no cycle. From then
/// on genes and reports are the second one's. It has random numbers of its own, so that none is used twice: the key of
/// its stream is words 0 (low) and 1 (high) of block (0, outside, 1). One environment only.
class Hybrid final : public Trainer {
 public:
  /// Throws std::invalid_argument if one of the two is missing.
  Hybrid(std::unique_ptr<Trainer> first, Refinement then, std::uint32_t first_evaluations);
  Hybrid(const Hybrid& other);

  fitness::Fitness begin(const Training& training) override { return present_->begin(training); }
  void advance(const Training& training, std::uint32_t budget, std::vector<CycleReport>& reports) override;
  std::span<const double> genes() const override { return present_->genes(); }
  bool can_be_saved() const override { return present_->can_be_saved(); }
  void save(const Training& training, saving::Writer& writer) const override;
  void restore(const Training& training, std::uint32_t cycles, saving::Reader& reader) override;
  std::unique_ptr<Trainer> clone() const override { return std::make_unique<Hybrid>(*this); }

 private:
  std::unique_ptr<Trainer> present_;
  Refinement then_;
  std::uint32_t left_;    ///< evaluations of the first
  bool refines_ = false;  ///< the second has begun
};

}  // namespace lamprey::science::evolution::trainers
