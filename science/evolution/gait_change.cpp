#include "science/evolution/gait_change.hpp"

#include <optional>
#include <stdexcept>

namespace lamprey::science::evolution {

namespace {

/// A mother's input is the first gene of its unit.
networks::Tonic tonic_of_genes(const GenePlan& plan, std::span<const double> genes) {
  networks::Tonic tonic{};
  for (std::size_t mother = 0; mother < tonic.size(); ++mother) {
    tonic[mother] = networks::pulse_of_gene(genes[plan.units[mother].front()]);
  }
  return tonic;
}

std::optional<networks::TonicGait> gait_of_genes(const GenePlan& plan, std::span<const double> genes) {
  return networks::gait_of(tonic_of_genes(plan, genes));
}

void redraw(const Training& training, std::uint32_t cycle, std::uint32_t mother, std::span<double> genes) {
  const GenePlan& plan = training.problem.plan();
  const auto words = training.stream.block(cycle, random::Purpose::mutation, mother);
  const auto& unit = plan.units[mother];
  genes[unit[0]] = random::bounded(words[0], 2) == 0 ? -1 : 1;
  if (unit.size() > 1) {
    const Gene& weight = plan.genes[unit[1]];
    genes[unit[1]] = weight.minimum + random::unit_interval(words[1], words[2]) * (weight.maximum - weight.minimum);
  }
}

fitness::Fitness try_from_standing(const Training& training, std::span<const double> genes) {
  Body standing;
  return training.problem.evaluate(genes, training.environment, standing);
}

}  // namespace

GaitChange::GaitChange(MutationTechnique mutation) : mutation_(mutation) {
  if (mutation == MutationTechnique::some) {
    throw std::invalid_argument("mutation is some; a change of gait has all and one");
  }
}

void GaitChange::start(const Problem& problem) {
  const auto preset = problem.preset();
  const GenePlan& plan = problem.plan();
  if (plan.units.size() != networks::tonic_mothers || preset.empty()) {
    throw std::invalid_argument("a change of gait needs the tonic network with a preset");
  }
  const auto gait = gait_of_genes(plan, preset);
  if (!gait) throw std::invalid_argument("the preset's tonic is no row of the table in 9.3");
  state_.gait = *gait;
  state_.genes.assign(preset.begin(), preset.end());
}

fitness::Fitness GaitChange::begin(const Training& training) {
  start(training.problem);
  return try_from_standing(training, state_.genes);
}

fitness::Fitness GaitChange::meet(const Training& training) {
  return try_from_standing(training, state_.genes);
}

void GaitChange::advance(const Training& training, std::uint32_t /*budget*/, std::vector<CycleReport>& reports) {
  const auto mothers = static_cast<std::uint32_t>(networks::tonic_mothers);
  if (mutation_ == MutationTechnique::all) {
    for (std::uint32_t mother = 0; mother < mothers; ++mother) redraw(training, state_.cycle, mother, state_.genes);
  } else {
    const auto words = training.stream.block(state_.cycle, random::Purpose::mutation_choice, 0);
    redraw(training, state_.cycle, random::bounded(words[0], mothers), state_.genes);
  }
  ++state_.cycle;
  CycleReport report{.fitness = try_from_standing(training, state_.genes), .accepted = true};

  const auto gait = gait_of_genes(training.problem.plan(), state_.genes);
  report.success = gait && *gait != state_.gait;
  if (report.success) {
    note_change(*gait, state_.failures);
    state_.failures = 0;
  } else {
    ++state_.failures;
  }
  reports.push_back(report);
}

void GaitChange::note_change(networks::TonicGait gait, std::uint32_t failures) {
  state_.gait = gait;
  state_.measures.push_back({"gait_change_failures", state_.changes, static_cast<double>(failures)});
  state_.measures.push_back({"gait_reached", state_.changes, static_cast<double>(gait)});
  ++state_.changes;
}

// Of the changes only the failures before each and the gait that it reached are kept: they give the measures and the
// present gait.

void GaitChange::save(const Training& training, saving::Writer& writer) const {
  fields(writer, training.problem.plan(), state_.genes);
  writer.whole("failures", state_.failures, 0, state_.cycle);
  writer.whole("changes", state_.changes, 0, state_.cycle);
  for (const Measure& measure : state_.measures) {
    writer.whole("failures or gait", static_cast<std::uint32_t>(measure.value), 0, state_.cycle);
  }
}

void GaitChange::restore(const Training& training, std::uint32_t cycles, saving::Reader& reader) {
  start(training.problem);
  state_.cycle = cycles;
  fields(reader, training.problem.plan(), state_.genes);
  reader.whole("failures", state_.failures, 0, cycles);
  std::uint32_t changes = 0;
  reader.whole("changes", changes, 0, cycles);
  while (state_.changes < changes) {
    std::uint32_t failures = 0;
    std::uint32_t gait = 0;
    reader.whole("failures before a change", failures, 0, cycles);
    reader.whole("gait", gait, static_cast<std::uint32_t>(networks::TonicGait::walk),
                 static_cast<std::uint32_t>(networks::TonicGait::pace));
    note_change(static_cast<networks::TonicGait>(gait), failures);
  }
}

std::vector<Measure> GaitChange::measures() const {
  std::vector<Measure> all = state_.measures;
  all.push_back({"failures_after_last_change", 0, static_cast<double>(state_.failures)});
  return all;
}

}  // namespace lamprey::science::evolution
