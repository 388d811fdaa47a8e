#pragma once

#include "science/evolution/rtea.hpp"
#include "science/evolution/trainers/off_line.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace lamprey::science::evolution::trainers {

struct IiRteaSettings {
  double mutation_rate = 75;  ///< percent of the genes, 0..100
  Posture posture = Posture::reset;
  FirstGenes first_genes{};
};

/// The initial implementation of the RTEA (6.2.2.7, fig. 6.29): one string of genes, begun at random; each cycle draws
/// mutation_rate % of them (operators::mutated_count, chosen without replacement) anew within their bounds, and keeps
/// the change only if the summed error falls. The rounding is the thesis's: 25 % of two genes are none, so nothing ever
/// changes; 25 % of three are one. On-line: it has a posture, as evolution::Rtea has.
///
/// Randomness of cycle c: which genes by block (c, mutation_choice, 0), the value of gene g by word g of (c, mutation,
/// 0).
class IiRtea final : public Trainer {
 public:
  /// Throws std::invalid_argument for a rate out of its range.
  explicit IiRtea(IiRteaSettings settings);

  fitness::Fitness begin(const Training& training) override;
  /// One cycle.
  void advance(const Training& training, std::uint32_t budget, std::vector<CycleReport>& reports) override;
  std::span<const double> genes() const override { return accepted_.genes; }
  fitness::Fitness meet(const Training& training) override;
  bool can_be_saved() const override { return true; }
  void save(const Training& training, saving::Writer& writer) const override;
  void restore(const Training& training, std::uint32_t cycles, saving::Reader& reader) override;
  std::unique_ptr<Trainer> clone() const override { return std::make_unique<IiRtea>(*this); }

 private:
  /// From standing or from where the last evaluation ended.
  fitness::Fitness evaluate(const Training& training, std::span<const double> genes);

  IiRteaSettings settings_;
  Member accepted_;
  Body body_;
  std::uint32_t cycle_ = 0;
};

}  // namespace lamprey::science::evolution::trainers
