#include "science/problems/biped_problem.hpp"

#include "science/fitness/biped_fitness.hpp"
#include "science/networks/feed_forward_pair.hpp"
#include "science/networks/recurrent_pair.hpp"
#include "science/neurons/acting_output.hpp"
#include "science/neurons/mcculloch_pitts.hpp"
#include "science/neurons/net_as_on_time.hpp"
#include "science/neurons/threshold.hpp"
#include "science/neurons/timed.hpp"
#include "science/robots/biped.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>

namespace lamprey::science::problems {

namespace {

/// What lives on between evaluations. Fresh, the chains of both legs hold them where they stand.
template <typename Neuron>
struct BipedBody {
  robots::Biped robot;
  networks::PairState<Neuron> network;
  std::array<actuators::ActuatorState, robots::biped_legs> actuator{
      actuators::at_rest(robots::touch_down_position - biped_standing_position),
      actuators::at_rest(robots::knee_release_position - biped_standing_position)};
};

template <typename Archive, typename State>
void body_fields(Archive& archive, State& body) {
  fields(archive, body.robot);
  networks::pair_fields(archive, body.network);
  for (auto& actuator : body.actuator) fields(archive, actuator);
}

template <typename Neuron>
neurons::WeightRange weight_range(BipedWeights weights) {
  const double minimum = weights == BipedWeights::as_printed ? Neuron::weights.minimum : -Neuron::weights.maximum;
  return {minimum, Neuron::weights.maximum, Neuron::weights.whole};
}

template <typename Topology, typename Neuron>
class BipedProblem final : public evolution::Problem {
 public:
  using Network = networks::Pair<Neuron>;
  using State = BipedBody<Neuron>;

  explicit BipedProblem(const BipedSettings& settings)
      : actuator_(settings.actuator),
        time_steps_(settings.time_steps),
        plan_(networks::pair_plan<Topology, Neuron>(weight_range<Neuron>(settings.weights))) {}

  const evolution::GenePlan& plan() const override { return plan_; }
  std::span<const double> preset() const override { return {}; }
  fitness::Fitness expected(const fitness::Environment&) const override { return fitness::perfect_antiphase; }

  fitness::Fitness evaluate(std::span<const double> genes, const fitness::Environment&,
                            evolution::Body& body) const override {
    const Network network = networks::pair_from_genes<Topology, Neuron>(genes);
    State state = body.get<State>();
    fitness::BipedCounts counts;
    for (std::int32_t t = 0; t < time_steps_; ++t) fitness::count(counts, advance(network, state).robot);
    body.put(state);
    return fitness::score(counts, time_steps_);
  }

  void save(const evolution::Body& body, saving::Writer& writer) const override {
    const auto now = body.get<State>();
    body_fields(writer, now);
  }
  void restore(saving::Reader& reader, evolution::Body& body) const override {
    State now;
    body_fields(reader, now);
    body.put(now);
  }

  robots::Recording record(std::span<const double> genes, const fitness::Environment&,
                           std::int32_t time_steps) const override {
    const Network network = networks::pair_from_genes<Topology, Neuron>(genes);
    State state;
    robots::Recording recording;
    recording.servos = {"leg 1", "leg 2"};
    recording.positions.push_back({state.robot.position.begin(), state.robot.position.end()});
    double distance = 0;
    for (std::int32_t t = 0; t < time_steps; ++t) {
      const Step done = advance(network, state);
      distance += done.robot.advance;
      recording.outputs.push_back({done.network.out.begin(), done.network.out.end()});
      recording.positions.push_back({state.robot.position.begin(), state.robot.position.end()});
      recording.distance.push_back(distance);
      recording.feet_on_ground.push_back(done.robot.feet_on_ground);
    }
    return recording;
  }

 private:
  struct Step {
    networks::PairStep network;
    robots::BipedStep robot;
  };

  Step advance(const Network& network, State& state) const {
    const networks::PairStep outputs = networks::step(network, state.network);
    robots::BipedCommands commands{};
    for (std::size_t leg = 0; leg < robots::biped_legs; ++leg) {
      commands[leg] = actuators::command(actuator_, actuators::OutputKind::pulses, outputs.out[leg],
                                         state.robot.position[leg], biped_standing_position, state.actuator[leg]);
    }
    return {outputs, robots::step(state.robot, commands)};
  }

  actuators::Actuator actuator_;
  std::int32_t time_steps_;
  evolution::GenePlan plan_;
};

template <typename Neuron>
std::unique_ptr<evolution::Problem> make(const BipedSettings& settings) {
  if (settings.network == BipedNetwork::recurrent_pair) {
    return std::make_unique<BipedProblem<networks::RecurrentPair, Neuron>>(settings);
  }
  return std::make_unique<BipedProblem<networks::FeedForwardPair, Neuron>>(settings);
}

}  // namespace

std::unique_ptr<evolution::Problem> make_biped_problem(const BipedSettings& settings) {
  if (settings.time_steps < 1) {
    throw std::invalid_argument("time_steps is " + std::to_string(settings.time_steps) + "; at least 1");
  }
  switch (settings.neuron) {
    case BipedNeuron::threshold:
      return make<neurons::ThresholdNeuron>(settings);
    case BipedNeuron::acting_output:
      return make<neurons::ActingOutputNeuron>(settings);
    case BipedNeuron::net_as_on_time:
      return make<neurons::NetAsOnTimeNeuron>(settings);
    case BipedNeuron::mcculloch_pitts:
      return make<neurons::McCullochPittsNeuron>(settings);
    case BipedNeuron::timed:
      return make<neurons::TimedNeuron>(settings);
  }
  throw std::invalid_argument("no such neuron");
}

}  // namespace lamprey::science::problems
