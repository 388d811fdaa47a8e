#pragma once

#include "science/evolution/trainer.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lamprey::science::evolution::known_problems {

/// A function of bounded genes whose smallest value is known. Its negative is the distance, so with `maximise` and a
/// weight of 1 the cost is the function itself. Writes down what it is asked.
class Minimisation final : public Problem {
 public:
  using Function = std::function<double(std::span<const double>)>;

  Minimisation(std::vector<Gene> genes, Function function) : function_(std::move(function)) {
    plan_.genes = std::move(genes);
    plan_.units.emplace_back();
    for (std::uint32_t gene = 0; gene < plan_.genes.size(); ++gene) plan_.units.front().push_back(gene);
    plan_.kinds = {{0}};
  }

  const GenePlan& plan() const override { return plan_; }
  std::span<const double> preset() const override { return {}; }
  /// The body counts its evaluations.
  fitness::Fitness evaluate(std::span<const double> genes, const fitness::Environment& /*environment*/,
                            Body& body) const override {
    asked.emplace_back(genes.begin(), genes.end());
    evaluations_of_body = body.get<int>() + 1;
    body.put(evaluations_of_body);
    return {.distance = -function_(genes)};
  }
  void save(const Body& body, saving::Writer& writer) const override {
    writer.whole("evaluations", body.get<int>(), 0, 1'000'000);
  }
  void restore(saving::Reader& reader, Body& body) const override {
    int evaluations = 0;
    reader.whole("evaluations", evaluations, 0, 1'000'000);
    body.put(evaluations);
  }
  fitness::Fitness expected(const fitness::Environment& /*environment*/) const override { return {}; }
  robots::Recording record(std::span<const double> /*genes*/, const fitness::Environment& /*environment*/,
                           std::int32_t /*time_steps*/) const override {
    return {};
  }

  double at(std::span<const double> genes) const { return function_(genes); }

  mutable std::vector<std::vector<double>> asked;
  mutable int evaluations_of_body = 0;  ///< of the body that was used last

 private:
  GenePlan plan_;
  Function function_;
};

inline std::vector<Gene> alike(std::size_t genes, double minimum, double maximum) {
  return std::vector<Gene>(genes, {.minimum = minimum, .maximum = maximum, .step_unit = (maximum - minimum) / 10});
}

/// Smallest, 0, where all genes are 1.5.
inline Minimisation sphere(std::size_t genes = 4) {
  return {alike(genes, -5, 5), [](std::span<const double> x) {
            double sum = 0;
            for (const double gene : x) sum += (gene - 1.5) * (gene - 1.5);
            return sum;
          }};
}

/// L. A. Rastrigin's: smallest, 0, where all genes are 0; a local minimum of at least 1 near every other whole point.
inline Minimisation rastrigin(std::size_t genes = 3) {
  return {alike(genes, -5.12, 5.12), [](std::span<const double> x) {
            double sum = 0;
            for (const double gene : x) sum += gene * gene + 10 - 10 * std::cos(2 * std::numbers::pi * gene);
            return sum;
          }};
}

/// How far eq. 3.1 is from 7.5: 2 sin p + 10 cos q + 11 r + s/1000000, each gene in 0..1. 0 on a surface, since r alone
/// covers 0..11.
inline Minimisation equation_3_1() {
  return {alike(4, 0, 1), [](std::span<const double> x) {
            const double value = 2 * std::sin(x[0]) + 10 * std::cos(x[1]) + 11 * x[2] + x[3] / 1'000'000;
            return std::fabs(value - 7.5);
          }};
}

/// Times, weights and a wide range mixed: what bounds, step units and whole genes are for. Costs below 0 happen.
inline Minimisation mixed() {
  return {{{.minimum = 1, .maximum = 10, .step_unit = 1, .whole = true},
           {.minimum = 0, .maximum = 1, .step_unit = 0.1},
           {.minimum = -100, .maximum = 100, .step_unit = 20},
           {.minimum = 1, .maximum = 10, .step_unit = 1, .whole = true},
           {.minimum = 0, .maximum = 0, .step_unit = 0}},
          [](std::span<const double> x) {
            return std::floor(x[0]) + std::fabs(x[1] - 0.3) + std::fabs(x[2]) / 50 - std::floor(x[3]) + x[4];
          }};
}

inline Training training(const Problem& problem, std::uint64_t key) {
  return {.problem = problem,
          .environment = {.weights = {.stability = 0, .distance = 1, .fuel = 0}, .terrain = {}},
          .objective = Objective::maximise,
          .expected = {},
          .stream = random::Stream(key)};
}

/// Everything that can be seen of a run.
struct Seen {
  double first = 0;            ///< cost of begin()
  std::vector<double> costs;   ///< per cycle
  std::vector<bool> accepted;  ///< per cycle
  std::vector<double> genes;   ///< at the end
  std::vector<std::vector<double>> asked;

  bool operator==(const Seen&) const = default;
  double best() const {
    double lowest = first;
    for (const double cost : costs) lowest = cost < lowest ? cost : lowest;
    return lowest;
  }
};

/// Trains for `evaluations` cycles, at most `portion` at a time.
inline Seen train(Trainer& trainer, const Minimisation& problem, std::uint64_t key, std::uint32_t evaluations,
                  std::uint32_t portion = 1'000'000) {
  problem.asked.clear();
  const Training given = training(problem, key);
  Seen seen;
  seen.first = -trainer.begin(given).distance;
  std::vector<CycleReport> reports;
  while (reports.size() < evaluations) {
    const auto left = evaluations - static_cast<std::uint32_t>(reports.size());
    trainer.advance(given, left < portion ? left : portion, reports);
  }
  for (const CycleReport& report : reports) {
    seen.costs.push_back(-report.fitness.distance);
    seen.accepted.push_back(report.accepted);
  }
  seen.genes.assign(trainer.genes().begin(), trainer.genes().end());
  seen.asked = problem.asked;
  return seen;
}

/// A trainer under test, ready to be made.
struct Named {
  std::string name;
  std::function<std::unique_ptr<Trainer>()> make;
  std::size_t uncounted = 0;  ///< evaluations in a run that are no cycles, besides begin()'s
};

inline void PrintTo(const Named& named, std::ostream* out) {
  *out << named.name;
}

}  // namespace lamprey::science::evolution::known_problems
