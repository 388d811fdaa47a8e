#pragma once

#include "science/actuators/actuator.hpp"
#include "science/evolution/problem.hpp"
#include "science/fitness/quadruped_fitness.hpp"
#include "science/problems/quadruped_controllers.hpp"
#include "science/robots/machine.hpp"
#include "science/robots/quadruped.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lamprey::science::problems {

/// "front left vertical" and so on, in the order of the servos.
std::vector<std::string> servo_names();

/// How far a step carries the body, in positions: that is for pictures, and so has eq. 7.3's window of 10..20 from and
/// to which a foot on the ground pushes; the fitness has none (eq. 7.8). Legs that push together push once.
double body_advance(const robots::Quadruped& before, const robots::Quadruped& after, const robots::QuadrupedStep& step,
                    const robots::Terrain& terrain);

/// The path from outputs to moves where they are the same: pulses and unit moves.
struct DirectPath {
  struct State {};
  static void state_fields(auto& /*archive*/, saving::Of<State> auto& /*state*/) {}

  static const robots::ServoCommands& commands(const networks::ChildOutputs& pulses, const robots::Quadruped&, State&) {
    return pulses;  // a child drives the servo of its own number
  }
};

/// Any other: every servo has an actuator of its own.
struct ActuatorPath {
  using State = std::array<actuators::ActuatorState, robots::servos>;
  static void state_fields(auto& archive, saving::Of<State> auto& state) {
    for (auto& actuator_state : state) fields(archive, actuator_state);
  }

  actuators::Actuator actuator;
  actuators::OutputKind kind;

  template <typename Outputs>
  robots::ServoCommands commands(const Outputs& outputs, const robots::Quadruped& robot, State& state) const {
    robots::ServoCommands commands;
    for (std::size_t servo = 0; servo < robots::servos; ++servo) {
      commands[servo] = actuators::command(actuator, kind, outputs[servo], robot.position[servo],
                                           robots::standing_position, state[servo]);
    }
    return commands;
  }
};

/// The quadruped of 7.2 under a controller, scored by 7.3. The loop over the time steps is compiled for each controller
/// and path.
template <Controller C, class Path>
class ControlledQuadruped final : public evolution::Problem {
 public:
  /// `wanted` is a problem whose preset's fitness is the expected one; none: this problem's own. `machine` is evaluated
  /// on in the simulation's place, and outlives this; none: the simulation.
  ControlledQuadruped(C controller, Path path, std::int32_t time_steps, std::unique_ptr<const Problem> wanted,
                      robots::Machine* machine = nullptr)
      : controller_(std::move(controller)),
        path_(std::move(path)),
        time_steps_(time_steps),
        plan_(controller_.plan()),
        preset_(controller_.preset_genes()),
        wanted_(std::move(wanted)),
        machine_(machine) {}

  const evolution::GenePlan& plan() const override { return plan_; }
  std::span<const double> preset() const override { return preset_; }

  fitness::Fitness evaluate(std::span<const double> genes, const fitness::Environment& environment,
                            evolution::Body& body) const override {
    const typename C::Parameters parameters = controller_.parameters(genes);
    const robots::GroundLevels ground = environment.terrain.ground_level;
    if (machine_ != nullptr) return evaluate_on(*machine_, parameters, environment, body);
    Body now = body.get<Body>();
    fitness::QuadrupedCounts counts;
    for (std::int32_t t = 0; t < time_steps_; ++t) {
      const typename C::Outputs outputs = step(parameters, now.controller);
      fitness::count(counts, robots::step(now.robot, path_.commands(outputs, now.robot, now.path), ground));
    }
    body.put(now);
    return fitness::score(counts, time_steps_, environment.terrain.push_factor);
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

  fitness::Fitness expected(const fitness::Environment& environment) const override {
    const Problem& wanted = wanted_ ? *wanted_ : *this;
    evolution::Body standing;
    return wanted.evaluate(wanted.preset(), environment, standing);
  }

  robots::Recording record(std::span<const double> genes, const fitness::Environment& environment,
                           std::int32_t time_steps) const override {
    const typename C::Parameters parameters = controller_.parameters(genes);
    const robots::Terrain& terrain = environment.terrain;
    Body now;
    double distance = 0;
    robots::Recording recording;
    recording.servos = servo_names();
    recording.positions.emplace_back(now.robot.position.begin(), now.robot.position.end());
    for (std::int32_t t = 0; t < time_steps; ++t) {
      const robots::Quadruped before = now.robot;
      const typename C::Outputs outputs = step(parameters, now.controller);
      const robots::QuadrupedStep done =
          robots::step(now.robot, path_.commands(outputs, now.robot, now.path), terrain.ground_level);
      distance += body_advance(before, now.robot, done, terrain);
      recording.outputs.emplace_back(outputs.begin(), outputs.end());
      recording.positions.emplace_back(now.robot.position.begin(), now.robot.position.end());
      recording.distance.push_back(distance);
      recording.feet_on_ground.push_back(done.feet_on_ground);
    }
    return recording;
  }

 private:
  struct Body {
    robots::Quadruped robot = robots::standing();
    typename C::State controller;
    [[no_unique_address]] typename Path::State path;
  };
  static void body_fields(auto& archive, saving::Of<Body> auto& body) {
    fields(archive, body.robot);
    fields(archive, body.controller);
    Path::state_fields(archive, body.path);
  }

  fitness::Fitness evaluate_on(robots::Machine& machine, const typename C::Parameters& parameters,
                               const fitness::Environment& environment, evolution::Body& body) const {
    while (true) {
      Body now = body.get<Body>();
      try {
        const fitness::QuadrupedCounts counts = observe(machine, parameters, now);
        body.put(now);
        return fitness::score(counts, time_steps_, environment.terrain.push_factor);
      } catch (const robots::EvaluationVoid&) {
        // Again, from where it began; the machine knows how often that makes sense.
      }
    }
  }

  /// Commands go on from commands: a servo that lags is not left behind for good. What counts is what is reported.
  fitness::QuadrupedCounts observe(robots::Machine& machine, const typename C::Parameters& parameters,
                                   Body& now) const {
    fitness::QuadrupedCounts counts;
    robots::MachineReport before = machine.begin(now.robot.position, time_steps_);
    for (std::int32_t t = 0; t < time_steps_; ++t) {
      const typename C::Outputs outputs = step(parameters, now.controller);
      const robots::Quadruped reported = robots::nearest_posture(before);
      const bool limit_pushed = robots::step(now.robot, path_.commands(outputs, reported, now.path)).limit_pushed;
      const robots::MachineReport after = machine.step(now.robot.position);
      fitness::count(counts, robots::observed_step(before, after, limit_pushed));
      before = after;
    }
    return counts;
  }

  C controller_;
  Path path_;
  std::int32_t time_steps_;
  evolution::GenePlan plan_;
  std::vector<double> preset_;
  std::unique_ptr<const Problem> wanted_;
  robots::Machine* machine_;
};

}  // namespace lamprey::science::problems
