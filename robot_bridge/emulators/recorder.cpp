#include "robot_bridge/emulators/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace lamprey::robot_bridge::emulators {

Recorder::Recorder(std::ostream* log) : log_(log) {
  if (log_ != nullptr) *log_ << "time_ns,servo,value,duration_ms\n";
}

void Recorder::target(unsigned servo, int value, Time duration, Time time) {
  log(servo, value, duration, time);
  Servo& record = servos_[servo];
  ++record.moves;
  record.lowest = std::min(record.lowest.value_or(value), value);
  record.highest = std::max(record.highest.value_or(value), value);
  if (!record.target) return;
  const int change = std::abs(value - *record.target);
  record.largest_change = std::max(record.largest_change, change);
  const double seconds = in_seconds(std::max(duration, time - record.commanded));
  if (change > 0 && seconds > 0) record.largest_speed = std::max(record.largest_speed, change / seconds);
  record.target = value;
  record.commanded = time;
}

void Recorder::turned_on(unsigned servo, double position, int value, Time time) {
  Servo& record = servos_[servo];
  ++record.times_turned_on;
  record.largest_jump = std::max(record.largest_jump, std::abs(value - position));
  record.target = value;
  record.commanded = time;
}

void Recorder::turned_off(unsigned servo, Time time) {
  log(servo, std::nullopt, Time::zero(), time);
  Servo& record = servos_[servo];
  ++record.times_turned_off;
  record.target.reset();
}

std::uint64_t Recorder::refusals() const {
  std::uint64_t sum = 0;
  for (const auto& [reason, count] : refused_) sum += count;
  return sum;
}

nlohmann::json Recorder::report() const {
  auto servos = nlohmann::json::object();
  for (const auto& [name, record] : servos_) {
    auto& servo = servos[std::to_string(name)] = {{"moves", record.moves},
                                                  {"times_turned_on", record.times_turned_on},
                                                  {"times_turned_off", record.times_turned_off},
                                                  {"lowest", nullptr},
                                                  {"highest", nullptr},
                                                  {"largest_change", record.largest_change},
                                                  {"largest_speed", record.largest_speed},
                                                  {"largest_jump", record.largest_jump}};
    if (record.lowest) servo["lowest"] = *record.lowest;
    if (record.highest) servo["highest"] = *record.highest;
  }
  return {{"servos", servos}, {"refused", refused_}, {"refusals", refusals()}};
}

void Recorder::log(unsigned servo, std::optional<int> value, Time duration, Time time) {
  if (log_ == nullptr) return;
  *log_ << time.count() << ',' << servo << ',';
  if (value) *log_ << *value;
  *log_ << ',' << std::chrono::duration<double, std::milli>(duration).count() << '\n';
}

}  // namespace lamprey::robot_bridge::emulators
