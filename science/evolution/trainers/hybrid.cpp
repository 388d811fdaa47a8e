#include "science/evolution/trainers/hybrid.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace lamprey::science::evolution::trainers {

namespace {

random::Stream refinement_stream(const random::Stream& stream) {
  const auto words = stream.block(0, random::Purpose::outside, 1);
  return random::Stream(std::uint64_t{words[1]} << 32 | words[0]);
}

Training of_refinement(const Training& training) {
  Training of_second = training;
  of_second.stream = refinement_stream(training.stream);
  return of_second;
}

}  // namespace

Hybrid::Hybrid(std::unique_ptr<Trainer> first, Refinement then, std::uint32_t first_evaluations)
    : present_(std::move(first)), then_(std::move(then)), left_(first_evaluations) {
  if (!present_ || !then_) throw std::invalid_argument("a hybrid needs a first trainer and a refinement");
}

Hybrid::Hybrid(const Hybrid& other)
    : Trainer(other),
      present_(other.present_->clone()),
      then_(other.then_),
      left_(other.left_),
      refines_(other.refines_) {}

void Hybrid::advance(const Training& training, std::uint32_t budget, std::vector<CycleReport>& reports) {
  if (left_ > 0) {
    const std::size_t before = reports.size();
    present_->advance(training, std::min(budget, left_), reports);
    left_ -= static_cast<std::uint32_t>(reports.size() - before);
    return;
  }
  const Training of_second = of_refinement(training);
  if (!refines_) {
    const auto found = present_->genes();
    std::unique_ptr<Trainer> second = then_({found.begin(), found.end()});
    second->begin(of_second);
    present_ = std::move(second);
    refines_ = true;
  }
  present_->advance(of_second, budget, reports);
}

// Which of the two is at work follows from the number of cycles: the second begins with the first cycle that the first
// one does not have.

void Hybrid::save(const Training& training, saving::Writer& writer) const {
  present_->save(refines_ ? of_refinement(training) : training, writer);
}

void Hybrid::restore(const Training& training, std::uint32_t cycles, saving::Reader& reader) {
  if (cycles <= left_) {
    left_ -= cycles;
    return present_->restore(training, cycles, reader);
  }
  // The genes are placeholders: the second one reads its own.
  std::unique_ptr<Trainer> second = then_(std::vector<double>(training.problem.plan().genes.size()));
  second->restore(of_refinement(training), cycles - left_, reader);
  present_ = std::move(second);
  refines_ = true;
  left_ = 0;
}

}  // namespace lamprey::science::evolution::trainers
