#pragma once

#include "robot_bridge/emulators/controller.hpp"
#include "robot_bridge/emulators/foot_switch.hpp"
#include "robot_bridge/emulators/recorder.hpp"
#include "robot_bridge/emulators/ssc32/channel.hpp"
#include "robot_bridge/emulators/ssc32/command.hpp"
#include "robot_bridge/emulators/ssc32/debounced_input.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace lamprey::robot_bridge::emulators::ssc32 {

struct Settings {
  std::vector<FootSwitch> feet;
  std::set<unsigned> servos;  ///< channels to tell of in the state, besides those that were commanded
  double position = 1500;     ///< of all servos before the first command, in µs
  double speed = 3333;        ///< of a servo, in µs per second: 0.2 s for 60°, a standard servo at 6 V
  std::string version = "SSC32-V2.50USB";
  /// The board's own defaults of its registers for transmit delay and pacing.
  Time answer_delay = std::chrono::microseconds{600};
  Time answer_gap = std::chrono::microseconds{70};
};

/// A Lynxmotion SSC-32U with servos and foot contacts.
class Ssc32 : public Controller {
 public:
  /// `recorder` outlives it; `now` is when it gets its power.
  Ssc32(Settings settings, Recorder& recorder, Time now);

  void receive(std::uint8_t octet, Time time) override;
  std::vector<Answer> take_answers() override;
  void disconnected() override { line_.clear(); }
  void overload(unsigned servo, bool on, Time time) override;
  void place(unsigned servo, double position, Time time) override;
  void reset(Time time) override;
  nlohmann::json state(Time time) override;

 private:
  void advance(Time time);
  bool at_rest() const;
  bool contact(unsigned input) const;
  Channel& existing(unsigned servo);
  void power_up();

  void act(const Nothing&, Time) {}
  void act(const Bad& bad, Time time);
  void act(const Move& move, Time time);
  void act(const Stop& stop, Time time);
  void act(const QueryMovement& query, Time time);
  void act(const QueryPulses& query, Time time);
  void act(const QueryVersion& query, Time time);
  void act(const ReadDigital& read, Time time);
  void act(const ReadAnalog& read, Time time);
  void answer(std::vector<std::uint8_t> octets, Time time);

  Settings settings_;
  Recorder* recorder_;
  std::vector<Channel> channels_;
  std::array<DebouncedInput, digital_inputs> inputs_;
  std::array<bool, analog_inputs> analog_{};  ///< pins that have become analog
  std::string line_;
  bool line_too_long_ = false;
  std::vector<Answer> answers_;
  Time advanced_;  ///< the last tick
  Time moving_until_{};
};

}  // namespace lamprey::robot_bridge::emulators::ssc32
