#pragma once

#include "science/evolution/problem.hpp"
#include "science/networks/children.hpp"
#include "science/problems/controlled_quadruped.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace lamprey::science::problems {

inline constexpr std::size_t wanted_frames = 9;

/// The wanted outputs of the walk, frame by frame (fig. 7.13b), as they follow from the times of fig. 7.13(a).
constexpr std::array<networks::ChildOutputs, wanted_frames> figure_7_13_outputs() {
  std::array<networks::ChildOutputs, wanted_frames> wanted{};
  // Back left, front left, back right, front right: a leg lifts and swings in one frame and lands in the next; in the
  // last all four push back.
  constexpr std::array<std::size_t, 4> vertical_in_turn{4, 0, 5, 1};
  for (std::size_t slot = 0; slot < vertical_in_turn.size(); ++slot) {
    const std::size_t vertical = vertical_in_turn[slot];
    const std::size_t horizontal = vertical + 2;
    wanted[2 * slot][vertical] = wanted[2 * slot][horizontal] = 1;
    wanted[2 * slot + 1][vertical] = -1;
    wanted[wanted_frames - 1][horizontal] = -1;
  }
  return wanted;
}

/// How far a network's outputs agree with those wanted of the walk (figs 7.17 and 7.22: the comparison that made the
/// thesis leave one network and then keep another). No robot. Stability is the share of the eight outputs of each time
/// step that are as wanted, per cent; the wanted nine frames are repeated for ever. Distance and fuel are 0.
template <Controller C>
class OutputAgreement final : public evolution::Problem {
 public:
  OutputAgreement(C controller, std::int32_t time_steps)
      : controller_(std::move(controller)),
        time_steps_(time_steps),
        plan_(controller_.plan()),
        preset_(controller_.preset_genes()) {}

  const evolution::GenePlan& plan() const override { return plan_; }
  std::span<const double> preset() const override { return preset_; }

  fitness::Fitness expected(const fitness::Environment&) const override { return {.stability = 100}; }

  fitness::Fitness evaluate(std::span<const double> genes, const fitness::Environment&,
                            evolution::Body& body) const override {
    static constexpr auto wanted = figure_7_13_outputs();
    const typename C::Parameters parameters = controller_.parameters(genes);
    Body now = body.get<Body>();
    std::int32_t agreeing = 0;
    for (std::int32_t t = 0; t < time_steps_; ++t) {
      const networks::ChildOutputs outputs = step(parameters, now.controller);
      for (std::size_t i = 0; i < networks::children; ++i) agreeing += outputs[i] == wanted[now.frame][i];
      now.frame = static_cast<std::uint8_t>((now.frame + 1) % wanted_frames);
    }
    body.put(now);
    const double cells = 8.0 * time_steps_;
    return {.stability = 100.0 * agreeing / cells};
  }

  void save(const evolution::Body& body, saving::Writer& writer) const override {
    const auto now = body.get<Body>();
    body_fields(writer, now);
  }
  void restore(saving::Reader& reader, evolution::Body& body) const override {
    Body now;
    body_fields(reader, now);
    body.put(now);
  }

  /// The positions are those of a robot that stands and is moved by the outputs.
  robots::Recording record(std::span<const double> genes, const fitness::Environment& environment,
                           std::int32_t time_steps) const override {
    return ControlledQuadruped<C, DirectPath>(controller_, {}, time_steps_, nullptr)
        .record(genes, environment, time_steps);
  }

 private:
  struct Body {
    std::uint8_t frame = 0;
    typename C::State controller;
  };
  static void body_fields(auto& archive, saving::Of<Body> auto& body) {
    archive.whole("frame", body.frame, 0, std::uint8_t{wanted_frames - 1});
    fields(archive, body.controller);
  }

  C controller_;
  std::int32_t time_steps_;
  evolution::GenePlan plan_;
  std::vector<double> preset_;
};

}  // namespace lamprey::science::problems
