#pragma once

#include "science/evolution/trainer.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace lamprey::science::evolution::trainers {

/// Gives the genes that member `member` (0-based) of a first population begins with; always the same for the same
/// member. Where a trainer's settings leave it empty, they are drawn uniformly within their bounds (3.3.2.3).
using FirstGenes = std::function<std::vector<double>(std::uint32_t member)>;

/// Throws std::invalid_argument if a maker gives another number of genes than the problem has.
std::vector<double> first_genes(const FirstGenes& maker, const Training& training, std::uint32_t member);

/// Throws std::invalid_argument, naming what is out of its range, unless minimum ≤ value ≤ maximum.
void require_within(std::string_view name, double value, double minimum, double maximum);

/// The sizes that a population may have; selection by rank counts up to the largest.
inline constexpr std::uint32_t smallest_population = 4;
inline constexpr std::uint32_t largest_population = 65'536;

/// A candidate that was tried.
struct Member {
  std::vector<double> genes;
  double cost = 0;
};

/// Far beyond the cost of any fitness.
inline constexpr double largest_cost = 1e8;

void fields(auto& archive, const GenePlan& plan, saving::Of<Member> auto& member) {
  fields(archive, plan, member.genes);
  saving::real_within(archive, "cost", member.cost, -largest_cost, largest_cost);
}

/// The costs of members, in order.
std::vector<double> costs(std::span<const Member> members);

/// What an off-line trainer tells of its attempts: each starts from standing, and one is accepted, and a success, if it
/// costs strictly less than every one before.
class BestSoFar {
 public:
  /// The first attempt; no cycle.
  fitness::Fitness first(const Training& training, std::vector<double> genes);

  /// A cycle: appends its report and gives the cost.
  double attempt(const Training& training, std::span<const double> genes, std::vector<CycleReport>& reports);

  const Member& best() const { return best_; }
  void restore(Member best) { best_ = std::move(best); }

 private:
  Member best_;
};

/// A trainer that tries generations of candidates. Generation 0 is the first population: begin() tries its member 0,
/// which is no cycle, and the others are the first cycles. A generation that a budget cuts short goes on with the next
/// advance, so what is tried, and in which order, never depends on how the evaluations were portioned.
class OffLine : public Trainer {
 public:
  fitness::Fitness begin(const Training& training) final;
  void advance(const Training& training, std::uint32_t budget, std::vector<CycleReport>& reports) final;
  /// The best so far.
  std::span<const double> genes() const final { return best_.best().genes; }

  bool can_be_saved() const final { return true; }
  void save(const Training& training, saving::Writer& writer) const final;
  void restore(const Training& training, std::uint32_t cycles, saving::Reader& reader) final;

 protected:
  /// `population` ≥ 1.
  OffLine(std::uint32_t population, FirstGenes maker) : population_(population), maker_(std::move(maker)) {}

  std::vector<double> first_member(const Training& training, std::uint32_t member) const {
    return first_genes(maker_, training, member);
  }

 private:
  /// Takes the first population, in order.
  virtual void found(std::vector<Member> population) = 0;
  /// The candidates of generation `generation` ≥ 1, at least one, in the order in which they are tried.
  virtual std::vector<std::vector<double>> breed(const Training& training, std::uint32_t generation) = 0;
  /// Decides who lives on, of those there were and of the candidates now tried.
  virtual void survive(const Training& training, std::uint32_t generation, std::vector<Member> children) = 0;

  /// What lives on from generation to generation, before generation `generation` ≥ 1 is bred. Breeding it again must
  /// give the same candidates.
  virtual void save_population(const Training& training, std::uint32_t generation, saving::Writer& writer) const = 0;
  virtual void restore_population(const Training& training, std::uint32_t generation, saving::Reader& reader) = 0;

  /// The candidates of the present generation, if there are none yet.
  void prepare(const Training& training);
  void conclude(const Training& training);

  std::uint32_t population_;
  FirstGenes maker_;
  BestSoFar best_;
  Member first_;
  std::uint32_t generation_ = 0;
  std::vector<std::vector<double>> candidates_;  ///< of the present generation; empty before it
  std::vector<double> tried_;                    ///< costs of those of them that were tried
};

}  // namespace lamprey::science::evolution::trainers
